// SPDX-License-Identifier: BSD-3-Clause
// Extreme materials: forces are proportional to E over twelve orders of magnitude, values outside
// the range of a float are reported, ν = 0 and 0.5 agree with closed forms and the tables of
// Data/Reference.
#include "FilterChecks.h"
#include "ReferenceTable.h"
#include "TestBodies.h"

#include <cfloat>
#include <cmath>

namespace
{
using namespace palpate::testing;

struct Response
{
  vtkSmartPointer<vtkFloatArray> force;
  vtkSmartPointer<vtkFloatArray> stiffness;
  int invalid = 0;
  std::string errors;
  std::string warnings;
};

Response respond(const std::string& tool, double young, double poisson, double range = 2.0,
  double layer = 0.0, int base = 0)
{
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(planeBody(1e4, 1));
  filter->SetTool(makeTool(tool));
  filter->SetYoungsModulus(young);
  filter->SetPoissonRatio(poisson);
  filter->SetMaximumDeflection(range);
  filter->SetLayerThickness(layer);
  filter->SetLayerBase(base);
  Messages messages(filter.Get());
  filter->Update();
  Response response;
  response.errors = messages.errors();
  response.warnings = messages.warnings();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  response.force = vtkFloatArray::SafeDownCast(data->GetArray("ResponseForce"));
  response.stiffness = vtkFloatArray::SafeDownCast(data->GetArray("ResponseStiffness"));
  vtkDataArray* status = data->GetArray("ResponseStatus");
  for (vtkIdType i = 0; status && i < status->GetNumberOfTuples(); ++i)
  {
    response.invalid += status->GetTuple1(i) == 2.0 ? 1 : 0; // code of NotFinite
  }
  return response;
}

/// Every stored value of `one` is `ratio` times that of `other`, within `units` in the last place.
void expectRatio(const Response& one, const Response& other, double ratio, double units)
{
  for (const auto& [a, b] :
    { std::pair{ one.force, other.force }, std::pair{ one.stiffness, other.stiffness } })
  {
    PALPATE_CHECK(a && b && a->GetNumberOfValues() == 32);
    for (vtkIdType i = 0; a && b && i < a->GetNumberOfValues(); ++i)
    {
      const auto expected = ratio * static_cast<double>(b->GetValue(i));
      PALPATE_CHECK(std::isnormal(a->GetValue(i)));
      PALPATE_CHECK_NEAR(static_cast<double>(a->GetValue(i)), expected,
        units * static_cast<double>(FLT_EPSILON) * expected);
    }
  }
}

/// Moduli from 1e-6 to 1e6 MPa, which include fat, cartilage, glass wool and steel.
void checkProportion()
{
  for (const char* tool : { "sphere:6.35", "flat:1.6", "cone:60", "rounded:3,1" })
  {
    const Response unit = respond(tool, 1.0, 0.3);
    // Powers of two scale without rounding; 2^±20 is about 1e±6.
    for (int power = -20; power <= 20; ++power)
    {
      expectRatio(respond(tool, std::ldexp(1.0, power), 0.3), unit, std::ldexp(1.0, power), 0.0);
    }
    for (int power = -6; power <= 6; ++power) // both values are rounded by half a unit when stored
    {
      expectRatio(
        respond(tool, std::pow(10.0, power), 0.3), unit, std::pow(10.0, power), 1.0 + 1e-6);
    }
  }
  const Response layer = respond("sphere:3", 1.0, 0.5, 1.0, 10.0);
  expectRatio(respond("sphere:3", 1e-6, 0.5, 1.0, 10.0), layer, 1e-6, 1.0 + 1e-6);
  expectRatio(respond("sphere:3", 1e6, 0.5, 1.0, 10.0), layer, 1e6, 1.0 + 1e-6);
}

void checkFloatStorage()
{
  // A tip of 10 nm that is pressed 1 nm into the softest body, and a roller of 100 m pressed a
  // metre into the hardest.
  for (const Response& response :
    { respond("paraboloid:1e-5", 1e-6, 0.0, 1e-6), respond("paraboloid:1e5", 1e6, 0.0, 1e3) })
  {
    PALPATE_CHECK(response.errors.empty() && response.warnings.empty() && response.invalid == 0);
  }
  // F = 4/3 E* √R δ^1.5 of the first sample, at δ = range/64.
  const auto first = [](const Response& response)
  { return static_cast<double>(response.force->GetValue(0)); };
  const double tiny = 4.0 / 3.0 * 1e-6 * std::sqrt(1e-5) * std::pow(1e-6 / 64.0, 1.5);
  PALPATE_CHECK_NEAR(
    first(respond("paraboloid:1e-5", 1e-6, 0.0, 1e-6)), tiny, 1.2e-7 * tiny); // 8e-21 N
  const double huge = 4.0 / 3.0 * 1e6 * std::sqrt(1e5) * std::pow(1e3 / 64.0, 1.5);
  PALPATE_CHECK_NEAR(first(respond("paraboloid:1e5", 1e6, 0.0, 1e3)), huge, 1.2e-7 * huge);

  // A value outside the range of a float is reported, not stored as 0, a denormal number or
  // infinity.
  for (const Response& response : { respond("flat:1", 1e-30, 0.0, 1e-8), // forces of 3e-40 N
         respond("flat:1", 1e300, 0.0), respond("flat:1", 3e38, 0.0),
         respond("sphere:3", 1e-40, 0.4, 1.0, 10.0) })
  {
    PALPATE_CHECK(response.errors.empty() && response.invalid == 4);
    PALPATE_CHECK_TEXT(response.warnings, "4 of 4 points have no response", "Status");
    for (vtkIdType i = 0; i < 32; ++i)
    {
      PALPATE_CHECK(response.force->GetValue(i) == 0.0F && response.stiffness->GetValue(i) == 0.0F);
    }
  }
}

void checkPoissonEnds()
{
  // F = 2aE*δ, with E* = E at ν = 0 and 4/3 E at ν = 0.5.
  for (const auto& [nu, modulus] : { std::pair{ 0.0, 0.06 }, std::pair{ 0.5, 0.08 } })
  {
    const Response response = respond("flat:1.6", 0.06, nu);
    const double last = 2.0 * 1.6 * modulus * 2.0;
    PALPATE_CHECK_NEAR(static_cast<double>(response.force->GetValue(7)), last, 1.2e-7 * last);
  }
  // Flat tools on layers: force / force on the half-space = κ(a/h, ν).
  const auto checkTable = [](const char* name, const char* rowName, const char* row, double nu,
                            vtkToolContactResponse::LayerBaseType base)
  {
    const ReferenceTable table(name);
    std::size_t i = 0;
    while (table.text(i, rowName) != row)
    {
      ++i;
    }
    for (const char* share : { "0.1", "0.5", "1.0", "2.0", "5.0" })
    {
      const double thickness = 3.0 / std::stod(share);
      const Response response = respond("flat:3", 0.1, nu, 0.2, thickness, base);
      const double last = table.number(i, share) * 2.0 * 3.0 * 0.1 / (1.0 - nu * nu) * 0.2;
      PALPATE_CHECK(response.errors.empty() && response.force);
      // LayerTable guarantees 1e-7; rounding to float adds half of this.
      PALPATE_CHECK_NEAR(static_cast<double>(response.force->GetValue(7)), last, 1.7e-7 * last);
    }
  };
  using Filter = vtkToolContactResponse;
  const char* const bonded = "layer_bonded_flat_kappa.csv";
  const char* const slip = "layer_slip_flat_kappa.csv";
  checkTable(bonded, "nu\\a_over_h", "0", 0.0, Filter::Bonded);
  checkTable(bonded, "nu\\a_over_h", "0.5", 0.5, Filter::Bonded);
  checkTable(slip, "a_over_h", "kappa(all nu)", 0.0, Filter::Slip);
  checkTable(slip, "a_over_h", "kappa(all nu)", 0.5, Filter::Slip);
}
} // namespace

int TestExtremeMaterials(int, char*[])
{
  checkProportion();
  checkFloatStorage();
  checkPoissonEnds();
  return palpate::testing::result();
}
