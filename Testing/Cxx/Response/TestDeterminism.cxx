// SPDX-License-Identifier: BSD-3-Clause
// Every filter that runs in threads, or whose kernel does, gives identical bits in all outputs with
// 1, 2 and 8 threads. The bodies are so large that each of eight threads has work.
#include "FilterChecks.h"
#include "ManyCores.h"
#include "MeasuredFiles.h"
#include "ProbedBall.h"

#include "vtkCellData.h"
#include "vtkContactDeflection.h"
#include "vtkContactRegime.h"
#include "vtkElasticCompliance.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkLayerThickness.h"
#include "vtkReducedContactResponse.h"
#include "vtkResponseChoice.h"
#include "vtkSkinSurface.h"
#include "vtkToolContactProbe.h"
#include "vtkVoxelBody.h"

#include <string>

namespace
{
using namespace palpate::testing;

constexpr double Radius = 40.0; // radius of the ball, mm
constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;

void addArrays(std::string& bytes, vtkFieldData* arrays)
{
  for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(k);
    bytes += array->GetName() ? array->GetName() : "";
    if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(array))
    {
      bytes.append(static_cast<const char*>(numbers->GetVoidPointer(0)),
        static_cast<std::size_t>(numbers->GetNumberOfValues() * numbers->GetDataTypeSize()));
      continue;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      bytes += array->GetVariantValue(i).ToString();
    }
  }
}

/// The bytes of points, triangles and all arrays.
std::string bytesOf(vtkPolyData* body)
{
  std::string bytes;
  vtkNew<vtkFieldData> geometry;
  geometry->AddArray(body->GetPoints()->GetData());
  geometry->AddArray(body->GetPolys()->GetConnectivityArray());
  addArrays(bytes, geometry);
  addArrays(bytes, body->GetPointData());
  addArrays(bytes, body->GetCellData());
  addArrays(bytes, body->GetFieldData());
  return bytes;
}

/// Compares the outputs of new filters from make(). `array` names an array that their output must
/// have.
template <class Make>
void check(const std::string& name, const char* array, const Make& make)
{
  std::string alone;
  for (const int threads : { 1, 2, 8 })
  {
    const ManyCores cores(threads);
    withThreads(threads,
      [&]
      {
        PALPATE_CHECK(vtkSMPTools::GetEstimatedNumberOfThreads() == threads);
        const auto filter = make();
        Messages messages(filter.Get());
        filter->Update();
        vtkPolyData* output = filter->GetOutput();
        PALPATE_CHECK(messages.none() && output->GetNumberOfPoints() > 0);
        PALPATE_CHECK(*array == '\0' || output->GetPointData()->HasArray(array));
        const std::string found = bytesOf(output);
        alone = threads == 1 ? found : alone;
        const bool same = found == alone;
        PALPATE_CHECK(same);
        if (!same)
        {
          std::cerr << name << " with " << threads << " threads\n";
        }
      });
  }
}

template <class Filter>
vtkSmartPointer<Filter> filterOf(vtkPolyData* body)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(body);
  return filter;
}

/// A scan of a ball in air, with fat 6 to 8 mm thick over bone; voxels of 1 mm, grey values as in
/// MRI.
vtkSmartPointer<vtkImageData> makeScan()
{
  auto scan = vtkSmartPointer<vtkImageData>::New();
  constexpr int Size = 91;
  scan->SetDimensions(Size, Size, Size);
  scan->SetOrigin(-44.7, -44.8, -45.2);
  scan->AllocateScalars(VTK_SHORT, 1);
  auto* grey = static_cast<short*>(scan->GetScalarPointer());
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    double x[3];
    scan->GetPoint(i, x);
    const double depth = Radius - vtkMath::Norm(x);
    const double thickness = 7.0 + std::sin(0.2 * x[0]) * std::cos(0.3 * x[1]);
    const auto edge = [](double away) { return std::min(1.0, std::max(0.0, 0.5 * away + 0.5)); };
    const double fat = std::min(edge(depth), edge(thickness - depth));
    const double speckle = static_cast<double>((i * 7919) % 13) - 6.0;
    grey[i] = static_cast<short>(std::lround(18.0 + 100.0 * fat + speckle));
  }
  return scan;
}

/// A ball with another modulus, thickness and compliance at each point.
Body mappedBall()
{
  Body body = sphereBody(Radius, 6); // a ball of 40962 points
  const auto wave = [&](double rate)
  {
    return [body, rate](vtkIdType i)
    {
      double x[3];
      body->GetPoint(i, x);
      return 1.0 + 0.4 * std::sin(rate * x[0]) * std::cos(0.5 * rate * x[1] + 0.1 * x[2]);
    };
  };
  pointArray(body, "E", [at = wave(0.3)](vtkIdType i) { return 0.1 * at(i); });
  pointArray(body, "Thickness", [at = wave(0.2)](vtkIdType i) { return 10.0 * at(i); });
  pointArray(body, "C", [at = wave(0.1)](vtkIdType i) { return 0.3 * at(i); });
  return body;
}

template <class Filter>
void takeArrays(Filter* filter, bool layers)
{
  filter->SetTool(makeTool("sphere:5"));
  filter->SetInputArrayToProcess(0, 0, 0, Points, "E");
  filter->SetInputArrayToProcess(layers ? 1 : 2, 0, 0, Points, layers ? "Thickness" : "C");
}

Body checkResponses(vtkPolyData* ball)
{
  Body made;
  for (const bool layers : { true, false })
  {
    check(layers ? "layers" : "compliance", "ResponseForce",
      [&]
      {
        auto filter = filterOf<vtkToolContactResponse>(ball);
        takeArrays(filter.Get(), layers);
        filter->Update();
        made = Body::New();
        made->ShallowCopy(filter->GetOutput());
        return filter;
      });
  }
  check("regime", "RegimeIndex",
    [&]
    {
      auto filter = filterOf<vtkContactRegime>(made);
      takeArrays(filter.Get(), false);
      return filter;
    });
  return made;
}

void checkMeasured(const std::string& folder)
{
  std::vector<MadeSite> sites;
  for (int i = 0; i < 4; ++i)
  {
    sites.push_back({ "S" + std::to_string(i), { 4.0 * (i % 2) - 2.0, 4.0 * (i / 2) - 2.0, 0.0 },
      hertz(6.35, 0.1 * (1 + i)) });
  }
  const std::string file =
    writeCurves(folder + "/determinism.csv", "paraboloid:6.35", sites, 1.5, 0.1, 0.001);
  check(
    "measured", "ResponseForce", [&] { return measure(planeBody(12.0, 100), file, "sphere:1.6"); });
}

void checkScan()
{
  const auto scan = makeScan();
  Body skin;
  check("skin", "",
    [&]
    {
      auto filter = vtkSmartPointer<vtkSkinSurface>::New();
      filter->SetInputData(scan);
      filter->SetContourValue(60.0);
      filter->SetClosingRadius(3.0);
      filter->SetResolution(1.5);
      filter->Update();
      skin = filter->GetOutput();
      return filter;
    });
  check("thickness", "LayerThickness",
    [&]
    {
      auto filter = filterOf<vtkLayerThickness>(skin);
      filter->SetScanData(scan);
      filter->SetSmoothingRadius(3.0);
      return filter;
    });
}

void checkElastic()
{
  vtkNew<vtkVoxelBody> voxels;
  voxels->SetInputData(boxBody(10.0, 8.0, 4.0, 4));
  voxels->SetSpacing(2.0);
  check("elastic", "GlobalCompliance",
    [&]
    {
      auto filter = vtkSmartPointer<vtkElasticCompliance>::New();
      filter->SetInputConnection(voxels->GetOutputPort());
      filter->SetNumberOfModes(3);
      return filter;
    });
}

/// A path in contact around the ball, as one history.
Body pathAround()
{
  Body tips = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(3000);
  for (int i = 0; i < 3000; ++i)
  {
    const double t = 0.002 * i;
    const double r = Radius - 1.2 * std::sin(3.0 * t);
    line->InsertCellPoint(points->InsertNextPoint(
      r * std::cos(t), r * std::sin(t) * std::cos(t), r * std::sin(t) * std::sin(t)));
  }
  tips->SetPoints(points);
  tips->SetLines(line);
  return tips;
}

void checkTouch(vtkPolyData* body)
{
  const Body loose = tipsInCube(5000, Radius, 7);
  Body felt;
  for (const bool history : { false, true })
  {
    for (const bool smooth : { false, true })
    {
      check(history ? "path" : "tips", "Force",
        [&]
        {
          auto filter = filterOf<vtkToolContactProbe>(body);
          filter->SetTipData(history ? pathAround() : loose);
          filter->SetContactSurface(smooth ? 1 : 0);
          filter->SetFrictionCoefficient(history ? 0.3 : 0.0);
          filter->Update();
          felt = filter->GetOutput();
          return filter;
        });
    }
  }
  check("deflection", "ContactDisplacement",
    [&]
    {
      auto filter = filterOf<vtkContactDeflection>(body);
      filter->SetTipData(felt);
      filter->SetTool(makeTool("sphere:5"));
      filter->SetTipIndex(800);
      return filter;
    });
}

void checkReduction(vtkPolyData* body)
{
  check(
    "reduction", "ResponseCoefficient", [&] { return filterOf<vtkReducedContactResponse>(body); });
  check("choice", "ResponseCoefficient", [&] { return filterOf<vtkResponseChoice>(body); });
}
} // namespace

int TestDeterminism(int, char* arguments[])
{
  const Body ball = mappedBall();
  const Body body = checkResponses(ball);
  checkTouch(body);
  checkReduction(body);
  checkMeasured(arguments[1]);
  checkScan();
  checkElastic();
  return result();
}
