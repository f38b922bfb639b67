// SPDX-License-Identifier: BSD-3-Clause
// One recorded trajectory gives the same bits in the probe filter, the servo step, a session in
// virtual time and the C interface, for every force form, surface and friction model. The body is
// bumpy and open, and its material differs from point to point. The trajectory presses and slides
// back and forth over many facets, beyond the range of the responses, over the border, out and in
// again. Some samples are not finite.
#include "Response/BodyConversion.h"
#include "EventfulPath.h"
#include "Response/FlatBodyConversion.h"
#include "Response/FilterChecks.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Haptics/palpate.h"

#include "vtkHapticSession.h"
#include "vtkToolContactProbe.h"

#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;
using palpate::Tick;

/// The numbers of a tick that all four report, as doubles, so that their bits can be compared.
using Numbers = std::vector<double>;

void append(Numbers& numbers, const double* values, int count)
{
  numbers.insert(numbers.end(), values, values + count);
}

Numbers numbersOf(const std::vector<Tick>& ticks)
{
  Numbers numbers;
  for (const Tick& tick : ticks)
  {
    append(numbers, tick.contact.force.data(), 3);
    append(numbers, tick.contact.friction.data(), 3);
    append(numbers, tick.contact.normal.data(), 3);
    append(numbers, tick.contact.contactPoint.data(), 3);
    const double rest[] = { tick.contact.normalForce, tick.contact.deflection,
      static_cast<double>(tick.contact.triangle), static_cast<double>(tick.contact.state) };
    append(numbers, rest, 4);
  }
  return numbers;
}

Numbers numbersOf(const std::vector<palpate_tick>& ticks)
{
  Numbers numbers;
  for (const palpate_tick& tick : ticks)
  {
    append(numbers, tick.force, 3);
    append(numbers, tick.friction, 3);
    append(numbers, tick.normal, 3);
    append(numbers, tick.contact_point, 3);
    const double rest[] = { tick.normal_force, tick.deflection, static_cast<double>(tick.triangle),
      static_cast<double>(tick.state) };
    append(numbers, rest, 4);
  }
  return numbers;
}

/// Returns the numbers of the probe's output, or of a recording.
Numbers numbersOf(vtkPolyData* felt)
{
  Numbers numbers;
  for (vtkIdType i = 0; i < felt->GetNumberOfPoints(); ++i)
  {
    for (const char* name : { "Force", "FrictionForce", "Normal", "ContactPoint", "NormalForce",
           "Deflection", "ContactCell", "ContactState" })
    {
      vtkDataArray* array = felt->GetPointData()->GetArray(name);
      double values[3] = { 0.0, 0.0, 0.0 };
      array->GetTuple(i, values);
      append(numbers, values, array->GetNumberOfComponents());
    }
  }
  return numbers;
}

bool sameBits(const Numbers& one, const Numbers& other)
{
  return one.size() == other.size() && !one.empty() &&
    std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) == 0;
}

/// Body, trajectory and two kernels of the body: one made with VTK, one read from the file.
struct Stage
{
  Body body = openBall();
  Body path = handPath();
  std::vector<palpate::DeviceSample> samples = samplesOf(this->path);
  std::shared_ptr<const palpate::ContactBody> kernel;
  std::unique_ptr<palpate_body, decltype(&palpate_body_free)> flat{ nullptr, &palpate_body_free };
  double maximumForce = palpate::DeviceSpecification().maximumForce;

  explicit Stage(const std::string& file)
  {
    std::string error;
    this->kernel = palpate::makeContactBody(this->body, "Response", error);
    PALPATE_CHECK(error.empty());
    PALPATE_CHECK(palpate::writeFlatBody(this->body, "Response", file).empty());
    this->flat.reset(palpate_body_load(file.c_str(), nullptr, 0));
    std::remove(file.c_str());
    PALPATE_CHECK(this->kernel != nullptr && this->flat != nullptr);
  }
};

std::vector<Tick> throughServo(const Stage& stage,
  const std::vector<palpate::DeviceSample>& samples, const palpate::ContactSettings& settings)
{
  palpate::ServoStep servo(
    *stage.kernel, palpate::WorkspaceMapping(), stage.maximumForce, settings);
  std::vector<Tick> ticks;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    ticks.push_back(servo.step(samples[i], static_cast<double>(i) * (1.0 / Rate)));
  }
  return ticks;
}

std::vector<palpate_tick> throughC(const Stage& stage,
  const std::vector<palpate::DeviceSample>& samples, const palpate::ContactSettings& settings)
{
  palpate_settings given;
  palpate_settings_default(&given);
  given.force_form = static_cast<int>(settings.form);
  given.contact_surface = static_cast<int>(settings.surface);
  given.friction_model = static_cast<int>(settings.friction.model);
  given.friction_coefficient = settings.friction.coefficient;
  given.tangential_stiffness = settings.friction.tangentialStiffness;
  given.poisson_ratio = settings.friction.poissonRatio;
  const std::unique_ptr<palpate_contact, decltype(&palpate_contact_free)> contact{
    palpate_contact_new_with(stage.flat.get(), stage.maximumForce, &given, nullptr, 0),
    &palpate_contact_free
  };
  std::vector<palpate_tick> ticks(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    palpate_step(
      contact.get(), samples[i].position.data(), static_cast<double>(i) * (1.0 / Rate), &ticks[i]);
  }
  return ticks;
}

/// Sets the settings in the filter or the session of VTK, which have the same properties.
template <class Felt>
void choose(Felt* felt, const palpate::ContactSettings& settings)
{
  felt->GetSettings()->SetForceForm(static_cast<int>(settings.form));
  felt->GetSettings()->SetContactSurface(static_cast<int>(settings.surface));
  felt->GetSettings()->SetFrictionModel(static_cast<int>(settings.friction.model));
  felt->GetSettings()->SetFrictionCoefficient(settings.friction.coefficient);
  felt->GetSettings()->SetTangentialStiffness(settings.friction.tangentialStiffness);
  felt->GetSettings()->SetPoissonRatio(settings.friction.poissonRatio);
}

/// Probes the tips of the servo step as one polyline, with NaN for ticks without a tip.
Body throughProbe(
  const Stage& stage, const std::vector<Tick>& ticks, const palpate::ContactSettings& settings)
{
  Body tips = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(ticks.size()));
  for (const Tick& tick : ticks)
  {
    const bool lost = tick.contact.state == palpate::ContactState::Invalid;
    const palpate::Vector3 tip = lost
      ? palpate::Vector3::Constant(std::numeric_limits<double>::quiet_NaN())
      : palpate::Vector3(tick.tip);
    line->InsertCellPoint(points->InsertNextPoint(tip.data()));
  }
  tips->SetPoints(points);
  tips->SetLines(line);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(stage.body);
  probe->SetTipData(tips);
  choose(probe.Get(), settings);
  probe->Update();
  return probe->GetOutput();
}

vtkSmartPointer<vtkHapticSession> throughSession(
  const Stage& stage, const palpate::ContactSettings& settings)
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  session->SetBody(stage.body);
  session->GetDevice()->SetPath(stage.path);
  session->SetRate(Rate);
  choose(session.Get(), settings);
  PALPATE_CHECK(session->Start());
  session->Step(Duration);
  return session;
}

/// Compares the tips and the sent forces, which only the servo step and the C interface report.
bool sameDeviceSide(const std::vector<Tick>& servo, const std::vector<palpate_tick>& c)
{
  bool same = servo.size() == c.size();
  for (std::size_t i = 0; same && i < c.size(); ++i)
  {
    same = std::memcmp(servo[i].deviceForce.data(), c[i].device_force, sizeof(double) * 3) == 0 &&
      std::memcmp(servo[i].tip.data(), c[i].tip, sizeof(double) * 3) == 0;
  }
  return same;
}

/// Checks that the trajectory has the events named at the top of this file.
void checkTrajectory(const std::vector<Tick>& ticks, const palpate::ContactSettings& settings)
{
  std::vector<int> states(6, 0);
  std::set<std::int32_t> triangles;
  int entered = 0;
  int rubbed = 0;
  int limited = 0;
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    const palpate::Contact& contact = ticks[i].contact;
    ++states[static_cast<std::size_t>(contact.state)];
    triangles.insert(contact.triangle);
    entered += i > 0 && contact.triangle >= 0 && ticks[i - 1].contact.triangle < 0;
    rubbed += contact.friction.norm() > 0.0;
    limited +=
      contact.friction.norm() > 0.999 * settings.friction.coefficient * contact.normalForce;
  }
  const bool hasFriction = settings.friction.coefficient > 0.0;
  PALPATE_CHECK(states[0] > 100);                  // outside
  PALPATE_CHECK((states[1] > 100) == hasFriction); // stick
  PALPATE_CHECK(states[2] > 100);                  // slide
  PALPATE_CHECK(states[3] > 100);                  // beyond range
  PALPATE_CHECK(states[4] > 20);                   // over the border
  PALPATE_CHECK(states[5] == 0);
  PALPATE_CHECK(triangles.size() > 40 && entered > 2);
  PALPATE_CHECK(hasFriction ? rubbed > 1000 && limited > 200 : rubbed == 0);
}

/// Replaces some samples by values that are not finite, in contact and outside.
std::vector<palpate::DeviceSample> withHoles(std::vector<palpate::DeviceSample> samples)
{
  for (std::size_t i = 50; i < samples.size(); i += 97)
  {
    samples[i].position[static_cast<Eigen::Index>(i % 3)] = i % 2 == 0
      ? std::numeric_limits<double>::quiet_NaN()
      : std::numeric_limits<double>::infinity();
  }
  return samples;
}

/// Checks that all four agree. Returns the numbers of all ticks, so that different settings can be
/// compared.
Numbers checkSettings(const Stage& stage, const palpate::ContactSettings& settings)
{
  const std::vector<Tick> servo = throughServo(stage, stage.samples, settings);
  checkTrajectory(servo, settings);
  const Numbers felt = numbersOf(servo);
  const std::vector<palpate_tick> c = throughC(stage, stage.samples, settings);
  PALPATE_CHECK(sameBits(numbersOf(c), felt) && sameDeviceSide(servo, c));
  PALPATE_CHECK(sameBits(numbersOf(throughProbe(stage, servo, settings)), felt));
  const auto session = throughSession(stage, settings);
  vtkNew<vtkPolyData> recording;
  session->GetRecorder()->GetRecording(recording);
  PALPATE_CHECK(sameBits(numbersOf(session->GetRecorder()->GetTicks()), felt));
  PALPATE_CHECK(sameBits(numbersOf(recording), felt));

  const auto holed = withHoles(stage.samples);
  const std::vector<Tick> servoHoled = throughServo(stage, holed, settings);
  const Numbers feltHoled = numbersOf(servoHoled);
  const std::vector<palpate_tick> cHoled = throughC(stage, holed, settings);
  PALPATE_CHECK(sameBits(numbersOf(cHoled), feltHoled) && !sameBits(feltHoled, felt));
  PALPATE_CHECK(sameDeviceSide(servoHoled, cHoled));
  PALPATE_CHECK(sameBits(numbersOf(throughProbe(stage, servoHoled, settings)), feltHoled));
  return felt;
}
} // namespace

int TestOnePath(int, char*[])
{
  const Stage stage("TestOnePath.palpate");
  std::vector<Numbers> all;
  for (const auto surface : { palpate::ContactSurface::Facets, palpate::ContactSurface::Smooth })
  {
    for (const auto form : { palpate::ForceForm::Paper, palpate::ForceForm::NormalizedDirection,
           palpate::ForceForm::EnergyConsistent })
    {
      for (const int friction : { -1, 0, 1, 2 }) // no friction, then the models
      {
        palpate::ContactSettings settings;
        settings.form = form;
        settings.surface = surface;
        settings.friction.coefficient = friction < 0 ? 0.0 : 0.5;
        settings.friction.model = static_cast<palpate::FrictionModel>(std::max(friction, 0));
        settings.friction.tangentialStiffness = 1.0;
        settings.friction.poissonRatio = 0.3;
        all.push_back(checkSettings(stage, settings));
        // Each setting has an effect: no two results are equal.
        for (std::size_t i = 0; i + 1 < all.size(); ++i)
        {
          PALPATE_CHECK(!sameBits(all[i], all.back()));
        }
      }
    }
  }
  return palpate::testing::result();
}
