// SPDX-License-Identifier: BSD-3-Clause
// Damaged response arrays: a valid body, changed at random in one to three places, is given to
// every filter that reads responses. Each filter must report an error or give finite results, and
// VTK itself must not report anything (this would fail the test). The second argument is the number
// of bodies. A failure reports the number of the body, which is its seed.
#include "Response/BodyConversion.h"
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkContactDeflection.h"
#include "vtkContactRegime.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkReducedContactResponse.h"
#include "vtkResponseChoice.h"
#include "vtkResponseCurves.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkToolContactProbe.h"
#include "vtkToolTouch.h"
#include "vtkUnsignedCharArray.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;
using palpate::Infinity;
using palpate::NotANumber;

/// Random numbers and choices for one body.
class Dice
{
public:
  explicit Dice(int seed)
    : Random(static_cast<unsigned>(seed))
  {
  }
  int below(int count) { return static_cast<int>(this->Random() % static_cast<unsigned>(count)); }
  template <class Value>
  Value of(std::initializer_list<Value> values)
  {
    return values.begin()[this->below(static_cast<int>(values.size()))];
  }
  double number()
  {
    return this->of({ 0.0, -0.0, 1.0, -1.0, 2.0, 7.0, 8.0, 9.0, 256.0, 257.0, 1e-40, 1e-30, 1e-3,
      1e9, 2147483648.0, -2147483649.0, 4294967296.0, 1e19, 3.4e38, -3.4e38, 1e300, NotANumber,
      Infinity, -Infinity });
  }

private:
  std::mt19937 Random;
};

Body compacted(const Body& body)
{
  vtkNew<vtkReducedContactResponse> reduce;
  reduce->SetInputData(body);
  reduce->Update();
  return reduce->GetOutput();
}

/// The body with the arrays of a layer, for its displacement field.
Body onALayer(const Body& body)
{
  Body layered = Body::New();
  layered->DeepCopy(body);
  pointArray<vtkDoubleArray>(layered, "ResponseLayerThickness", [](vtkIdType) { return 7.0; });
  return layered;
}

/// The same body with one global mode.
Body bending(const Body& body)
{
  Body bent = Body::New();
  bent->DeepCopy(body);
  vtkNew<vtkFloatArray> mode;
  mode->SetName("GlobalMode0");
  mode->SetNumberOfComponents(3);
  mode->SetNumberOfTuples(body->GetNumberOfPoints());
  mode->Fill(0.1);
  bent->GetPointData()->AddArray(mode);
  vtkNew<vtkDoubleArray> sign;
  sign->SetName("GlobalModeSign");
  sign->InsertNextValue(1.0);
  bent->GetFieldData()->AddArray(sign);
  palpate::describeModel(bent, "Response",
    { "half-space + compliance", palpate::HalfSpacePart | palpate::GlobalCompliancePart });
  return bent;
}

/// The same body with relaxation, in every form.
Body relaxing(const Body& body)
{
  Body relaxed = Body::New();
  relaxed->DeepCopy(body);
  palpate::PronySeries series;
  series.add(0.5, 0.1);
  series.add(0.25, 2.0);
  palpate::describeRelaxation(relaxed, "Response", series);
  vtkNew<vtkFloatArray> strength;
  strength->SetName("ResponseLocalRelaxation");
  strength->SetNumberOfComponents(2);
  strength->SetNumberOfTuples(body->GetNumberOfPoints());
  strength->Fill(0.75);
  relaxed->GetPointData()->AddArray(strength);
  pointArray<vtkFloatArray>(relaxed, "ResponseElasticCompliance", [](vtkIdType) { return 0.01F; });
  return relaxed;
}

/// Bodies with a response per point, or with laws and coefficients, and with the arrays for a
/// regime.
std::vector<Body> soundBodies()
{
  const Body plane = planeBody(10.0, 2);
  pointArray<vtkDoubleArray>(plane, "GlobalCompliance", [](vtkIdType i) { return 0.01 * (1 + i); });
  const Body perPoint = withResponse(plane, "sphere:5");
  const Body round = withResponse(sphereBody(8.0, 0), "cone:60");
  return { perPoint, round, compacted(perPoint), compacted(round), onALayer(perPoint),
    bending(round), relaxing(perPoint), relaxing(compacted(round)) };
}

vtkSmartPointer<vtkAbstractArray> anotherType(Dice& dice)
{
  switch (dice.below(6))
  {
    case 0:
      return vtkSmartPointer<vtkDoubleArray>::New();
    case 1:
      return vtkSmartPointer<vtkIntArray>::New();
    case 2:
      return vtkSmartPointer<vtkUnsignedCharArray>::New();
    case 3:
      return vtkSmartPointer<vtkLongLongArray>::New();
    case 4:
      return vtkSmartPointer<vtkStringArray>::New();
    default:
      return vtkSmartPointer<vtkFloatArray>::New();
  }
}

/// An array of another type or shape with as many of the values as fit.
vtkSmartPointer<vtkAbstractArray> reshaped(vtkAbstractArray* array, Dice& dice)
{
  vtkSmartPointer<vtkAbstractArray> other = anotherType(dice);
  if (dice.below(2) == 0)
  {
    other.TakeReference(array->NewInstance());
  }
  const int components = array->GetNumberOfComponents();
  const vtkIdType tuples = array->GetNumberOfTuples();
  other->SetName(array->GetName());
  other->SetNumberOfComponents(
    dice.of({ components, components, 1, 2, 3, components + 1, 2 * components, 512 }));
  other->SetNumberOfTuples(
    dice.of<vtkIdType>({ tuples, tuples, 0, 1, 2, tuples - 1, tuples + 1, 300 }));
  auto* numbers = vtkDataArray::SafeDownCast(other);
  auto* before = vtkDataArray::SafeDownCast(array);
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfValues(); ++i)
  {
    const bool has = before && before->GetNumberOfValues() > i;
    numbers->SetVariantValue(i, has ? before->GetVariantValue(i) : vtkVariant(1.0));
  }
  return other;
}

/// The nearest value that the array can hold.
double fitting(vtkDataArray* array, double value)
{
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  if (!std::isfinite(value))
  {
    return isReal ? value : 0.0;
  }
  const double half =
    0.5 * array->GetDataTypeMax(); // double cannot represent the largest 64-bit integer
  return std::clamp(value, std::max(-half, array->GetDataTypeMin()), half);
}

void spoilText(vtkStringArray* text, Dice& dice)
{
  text->SetNumberOfValues(1);
  text->SetValue(0,
    dice.of<const char*>({ "", "sphere", "sphere:0", "sphere:1e300", "cone:90", "flat:nan",
      "profile:0,0;1,1e-300", "power:1e9,1", "\xff\xfe", "%s%n" }));
}

/// Changes one value, a few, or all.
void spoilNumbers(vtkDataArray* numbers, Dice& dice)
{
  const double value = fitting(numbers, dice.number());
  const auto count = static_cast<int>(numbers->GetNumberOfTuples());
  const int share = dice.of({ 1, 3, count + 1 });
  for (int i = 0; i < count; ++i)
  {
    for (int k = 0; k < numbers->GetNumberOfComponents(); ++k)
    {
      if (dice.below(share) == 0)
      {
        numbers->SetComponent(i, k, value);
      }
    }
  }
}

/// Changes one array of the response.
void spoilArray(vtkFieldData* arrays, Dice& dice)
{
  if (arrays->GetNumberOfArrays() == 0)
  {
    return;
  }
  vtkAbstractArray* array = arrays->GetAbstractArray(dice.below(arrays->GetNumberOfArrays()));
  const int what = dice.below(8);
  if (what == 0)
  {
    arrays->RemoveArray(array->GetName());
  }
  else if (what <= 2)
  {
    arrays->AddArray(reshaped(array, dice));
  }
  else if (auto* text = vtkStringArray::SafeDownCast(array))
  {
    spoilText(text, dice);
  }
  else if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    spoilNumbers(numbers, dice);
  }
}

void spoil(vtkPolyData* body, Dice& dice)
{
  const int what = dice.below(16);
  if (what == 0)
  {
    spoilNumbers(body->GetPoints()->GetData(), dice);
  }
  else if (what == 1)
  {
    body->GetPolys()->ReplaceCellAtId(0, 3,
      std::array<vtkIdType, 3>{ 0, 1, dice.of<vtkIdType>({ -1, 1, 1000, 1LL << 40 }) }.data());
  }
  else
  {
    spoilArray(what < 7 ? body->GetFieldData() : body->GetPointData(), dice);
  }
}

Body spoiled(const Body& sound, Dice& dice)
{
  Body body = Body::New();
  body->DeepCopy(sound);
  for (int times = 1 + dice.below(3); times > 0; --times)
  {
    spoil(body, dice);
  }
  return body;
}

bool isFinite(vtkFieldData* data, std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    vtkDataArray* array = data->GetArray(name);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        if (!std::isfinite(array->GetComponent(i, k)))
        {
          return false;
        }
      }
    }
  }
  return true;
}

/// Tips of one history and some single tips. They are not changed.
Body soundTips()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double depth : { 0.5, -0.1, -0.5, -1.9, -2.5 })
  {
    points->InsertNextPoint(0.5 - depth, 0.7, depth);
    points->InsertNextPoint(depth, 0.3, 8.0 + depth);
  }
  auto tips = Body::New();
  tips->SetPoints(points);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 2, 4, 6, 8 });
  tips->SetLines(lines);
  pointArray<vtkDoubleArray>(
    tips, "Time", [](vtkIdType i) { return 0.05 * static_cast<double>(i); });
  return tips;
}

/// All filters that read responses, made once.
class Readers
{
public:
  Readers()
    : Tips(soundTips())
  {
    this->Probe->SetTipData(this->Tips);
    this->Probe->SetFrictionCoefficient(0.5);
    this->Field->SetInputConnection(1, this->Probe->GetOutputPort());
    this->Curves->AddPointId(0);
    this->Curves->AddPointId(5);
    this->Curves->SetNumberOfRows(21);
    this->Touch->SetTipPosition(0.5, 0.7, 8.0);
  }

  /// True if all filters behaved as required.
  bool read(vtkPolyData* body, Dice& dice)
  {
    this->Probe->SetForceForm(dice.below(3));
    this->Probe->SetContactSurface(dice.below(2));
    this->Probe->SetFrictionModel(dice.below(3));
    this->Probe->SetRelaxationElements(dice.of({ 0, 3, 16, 32 }));
    this->Choose->SetShare(dice.of({ 1.0, 0.5 }));
    return this->update(this->Probe, body,
             { "Force", "NormalForce", "FrictionForce", "MemoryForce", "Deflection", "Normal",
               "ContactPoint" }) &&
      this->update(this->Field, body, { "ContactDisplacement" }) &&
      this->update(this->Regime, body, {}) && this->update(this->Reduce, body, {}) &&
      this->update(this->Choose, body, {}) && this->update(this->Curves, body, {}) &&
      // Drawing a tool takes fifty times as long as the other filters together.
      (dice.below(50) > 0 || this->update(this->Touch, body, {}));
  }

private:
  bool update(vtkAlgorithm* reader, vtkPolyData* body, std::initializer_list<const char*> names)
  {
    const Messages messages(reader);
    reader->SetInputDataObject(0, body);
    reader->Update();
    vtkDataObject* output = reader->GetOutputDataObject(0);
    auto* points = vtkPolyData::SafeDownCast(output);
    const bool good =
      !messages.errors().empty() || !points || isFinite(points->GetPointData(), names);
    if (!good)
    {
      std::cerr << reader->GetClassName() << " reports no error and gives what is not finite"
                << std::endl;
    }
    return good;
  }

  Body Tips;
  vtkNew<vtkToolContactProbe> Probe;
  // filters that take the output of the probe run the probe again
  Messages ProbeMessages{ this->Probe.Get() };
  vtkNew<vtkContactDeflection> Field;
  vtkNew<vtkContactRegime> Regime;
  vtkNew<vtkReducedContactResponse> Reduce;
  vtkNew<vtkResponseChoice> Choose;
  vtkNew<vtkResponseCurves> Curves;
  vtkNew<vtkToolTouch> Touch;
};
} // namespace

int TestMutatedResponse(int argc, char* argv[])
{
  const int count = argc > 2 ? std::atoi(argv[2]) : 600;
  const int first = argc > 3 ? std::atoi(argv[3]) : 1;
  const std::vector<Body> sound = soundBodies();
  Readers readers;
  for (int seed = first; seed < first + count; ++seed)
  {
    Dice dice(seed);
    const Body body =
      spoiled(sound[static_cast<std::size_t>(dice.below(static_cast<int>(sound.size())))], dice);
    const bool good = readers.read(body, dice);
    if (!good)
    {
      std::cerr << "body " << seed << std::endl;
    }
    PALPATE_CHECK(good);
  }
  return palpate::testing::result();
}
