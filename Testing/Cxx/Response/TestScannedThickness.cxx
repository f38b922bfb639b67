// SPDX-License-Identifier: BSD-3-Clause
// The error of a force because of a scanned thickness: on scans of known thickness with noise, and
// between neighbouring points where the bone has holes and ends.
#include "FilterChecks.h"
#include "MadeScan.h"
#include "TestBodies.h"

#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/ReducedModulus.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkLayerThickness.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace palpate::testing;
using palpate::LayerBase;

constexpr double Young = 0.035; // MPa
constexpr double Ratio = 0.49;
constexpr double Deepest = 2.0; // mm
constexpr int SampleCount = 8;
constexpr double SearchDepth = 20.0; // mm, the filter's default MaximumDepth

double depthOf(int sample)
{
  return Deepest * std::pow((sample + 1.0) / SampleCount, 2); // as in the data contract
}

/// `grey` with noise of this standard deviation, the same in every run.
Grey noisy(Grey grey, double deviation)
{
  return [grey = std::move(grey), deviation, random = std::mt19937(11)](const double x[3]) mutable
  { return grey(x) + std::normal_distribution<double>(0.0, deviation)(random); };
}

Body scanned(vtkPolyData* body, vtkImageData* scan)
{
  vtkNew<vtkLayerThickness> filter;
  filter->SetInputData(0, body);
  filter->SetScanData(scan);
  filter->Update();
  Body found = filter->GetOutput();
  return found;
}

/// The response of a sphere of 6.35 mm on the scanned layer, with or without the error of the
/// thickness.
Body pressed(vtkPolyData* body, bool hasError)
{
  vtkNew<vtkPolyData> input;
  input->ShallowCopy(body);
  if (!hasError)
  {
    input->GetPointData()->RemoveArray("LayerThicknessError");
  }
  vtkNew<vtkContactTool> sphere;
  sphere->SetSpecification("sphere:6.35");
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(input);
  filter->SetTool(sphere);
  filter->SetYoungsModulus(Young);
  filter->SetPoissonRatio(Ratio);
  filter->SetMaximumDeflection(Deepest);
  filter->SetInputArrayToProcess(1, 0, 0, 0, "LayerThickness");
  filter->Update();
  Body made = filter->GetOutput();
  return made;
}

double valueOf(vtkPolyData* body, const char* array, vtkIdType point, int component = 0)
{
  return body->GetPointData()->GetArray(array)->GetComponent(point, component);
}

/// Force on a layer of this thickness at a sample, from a separate solution; 0: a half-space.
double forceOn(double thickness, int sample)
{
  vtkNew<vtkContactTool> sphere;
  sphere->SetSpecification("sphere:6.35");
  const palpate::AxisymmetricTool& tool = *sphere->GetKernel();
  const double modulus = palpate::reducedModulus(Young, Ratio);
  return thickness > 0.0
    ? palpate::LayerContact(tool, palpate::LayerKernel::shared(Ratio, LayerBase::Bonded), thickness)
        .evaluate(depthOf(sample), modulus)
        .force
    : tool.force(depthOf(sample), modulus);
}

/// How often the force lies within the part of the error that the thickness causes.
struct Coverage
{
  double share;   ///< of points and samples
  double typical; ///< median of the stated part
};

/// `thickness(x, y)` is the true one, below the plane z = 0. The scan lies lower by `shift` (mm).
Coverage coverageOf(
  const std::function<double(double, double)>& thickness, double noise, double shift)
{
  const auto scan =
    scanOf(noisy(
             [&](const double x[3])
             {
               const double depth = -x[2];
               return depth < 0.0 ? Air : edge(thickness(x[0], x[1]) + shift - depth, Bone, Fat);
             },
             noise),
      30.0);
  const Body layered = scanned(planeBody(20.0, 40), scan);
  const Body plain = pressed(layered, false);
  const Body stated = pressed(layered, true);
  int inside = 0;
  std::vector<double> parts;
  for (vtkIdType i = 0; i < layered->GetNumberOfPoints(); i += 3)
  {
    const double* x = layered->GetPoint(i);
    const double own = thickness(x[0], x[1]);
    for (const int sample : { 2, 4, 7 })
    {
      const double force = valueOf(stated, "ResponseForce", i, sample);
      const double part =
        valueOf(stated, "ResponseError", i, sample) - valueOf(plain, "ResponseError", i, sample);
      parts.push_back(part);
      inside += std::abs(forceOn(own, sample) - force) <= part * force ? 1 : 0;
    }
  }
  std::nth_element(parts.begin(), parts.begin() + parts.size() / 2, parts.end());
  return { static_cast<double>(inside) / static_cast<double>(parts.size()),
    parts[parts.size() / 2] };
}

/// The stated part holds at 95 % of the places, and is no larger than the effect of half a voxel
/// plus the unevenness of the layer.
void testCoverage()
{
  const auto even = [](double, double) { return 7.37; };
  const auto wavy = [](double x, double y)
  {
    return 8.0 +
      1.5 * std::sin(2.0 * palpate::Pi * x / 30.0) * std::cos(2.0 * palpate::Pi * y / 40.0);
  };
  const auto steep = [](double x, double) { return 10.0 + 0.25 * x; };
  // Noise as in magnetic resonance: 1/20 and 1/10 of the brightness of fat. A shift of fat against
  // water by 0.4 of a voxel.
  for (const auto& [noise, shift] :
    { std::pair{ 6.0, 0.0 }, { 12.0, 0.0 }, { 6.0, 0.4 }, { 6.0, -0.4 } })
  {
    for (const auto& thickness :
      { std::function<double(double, double)>(even), { wavy }, { steep } })
    {
      const Coverage found = coverageOf(thickness, noise, shift);
      PALPATE_CHECK(found.share >= 0.95);
      // The force is at most proportional to h^(-3/2) (Hertz to a compressed sheet); half a voxel
      // and as much unevenness are an eighth of 8 mm.
      PALPATE_CHECK(found.typical > 0.0 && found.typical < 0.25);
    }
  }
}

/// The edges of the triangles, each once.
std::set<std::pair<vtkIdType, vtkIdType>> edgesOf(vtkPolyData* body)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < body->GetNumberOfCells(); ++cell)
  {
    body->GetCellPoints(cell, corners);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(corners->GetId(k), corners->GetId((k + 1) % 3)));
    }
  }
  return edges;
}

/// Number of neighbours whose forces differ by more than both stated errors, at any sample.
int contradictions(vtkPolyData* body)
{
  int count = 0;
  for (const auto& [i, j] : edgesOf(body))
  {
    bool agrees = true;
    for (int sample = 0; sample < SampleCount; ++sample)
    {
      const auto errorOf = [&](vtkIdType at) {
        return valueOf(body, "ResponseForce", at, sample) *
          valueOf(body, "ResponseError", at, sample);
      };
      const double jump = std::abs(
        valueOf(body, "ResponseForce", i, sample) - valueOf(body, "ResponseForce", j, sample));
      agrees = agrees && jump <= errorOf(i) + errorOf(j);
    }
    count += agrees ? 0 : 1;
  }
  return count;
}

constexpr double HeadRadius = 40.0;
constexpr double Scalp = 7.0; // mm

using Direction = std::array<double, 3>;

/// Unit vectors on a spiral around the upper pole, which keeps them apart.
std::vector<Direction> spiral(int count)
{
  constexpr double goldenAngle = 2.399963229728653; // π (3 - √5)
  constexpr double lowest = 0.3;
  std::vector<Direction> directions;
  for (int k = 0; k < count; ++k)
  {
    const double height = lowest + (1.0 - lowest) * (k + 0.5) / count;
    const double side = std::sqrt(1.0 - height * height);
    directions.push_back(
      { side * std::cos(k * goldenAngle), side * std::sin(k * goldenAngle), height });
  }
  return directions;
}

/// A ball with bone below its upper half. The bone has holes that are three voxels wide.
Body smallHead()
{
  const std::vector<Direction> holes = spiral(12);
  constexpr double holeAngle = 1.5 / (HeadRadius - Scalp);
  const auto grey = [&](const double x[3])
  {
    Direction direction = { x[0], x[1], x[2] };
    const double depth = HeadRadius - vtkMath::Normalize(direction.data());
    const auto isNear = [&direction](const Direction& hole) {
      return vtkMath::Distance2BetweenPoints(direction.data(), hole.data()) < holeAngle * holeAngle;
    };
    if (depth < 0.5 * Scalp)
    {
      return edge(depth, Air, Fat);
    }
    const bool isBony = x[2] > 0.0 && std::none_of(holes.begin(), holes.end(), isNear);
    return isBony ? edge(Scalp - depth, Bone, Fat) : Fat;
  };
  Body body = sphereBody(HeadRadius, 5);
  addRadialNormals(body);
  return scanned(body, scanOf(noisy(grey, 6.0), HeadRadius + 5.0));
}

void testNeighbours()
{
  const Body head = smallHead();
  const int without = contradictions(pressed(head, false));
  const int with = contradictions(pressed(head, true));
  PALPATE_CHECK(without > 0); // the errors of the law alone do not explain the end of the bone
  PALPATE_CHECK(with == 0);
  // The mean reaches 3 mm, seen from the bone at its edge, which is blurred by 2 mm.
  constexpr double beyondEdge = 6.0;
  // A hole is 1.8 mm wide on the skin, as a radius: 36 % of the area of 3 mm over which it counts.
  constexpr double holeShare = 0.36;
  int wrong = 0;
  for (vtkIdType i = 0; i < head->GetNumberOfPoints(); ++i)
  {
    const double height = head->GetPoint(i)[2];
    const double thickness = valueOf(head, "LayerThickness", i);
    const bool isLayer = thickness > 0.9 * Scalp && thickness < Scalp / (1.0 - holeShare);
    wrong += (height > beyondEdge && !isLayer) || (height < -beyondEdge && thickness > 0.0) ? 1 : 0;
  }
  PALPATE_CHECK(wrong == 0); // no hole makes a half-space, and the bone ends at its edge
}

/// Without bone down to the end of the search, there may be bone just below.
void testHalfSpace()
{
  const auto scan = scanOf([](const double x[3]) { return x[2] > 0.0 ? Air : Fat; }, 30.0);
  const Body layered = scanned(planeBody(10.0, 10), scan);
  PALPATE_CHECK(valueOf(layered, "LayerThickness", 60) == 0.0);
  const Body plain = pressed(layered, false);
  const Body stated = pressed(layered, true);
  for (int sample = 0; sample < SampleCount; ++sample)
  {
    const double part =
      valueOf(stated, "ResponseError", 60, sample) - valueOf(plain, "ResponseError", 60, sample);
    // Rounding of errors of order 1 to floats.
    PALPATE_CHECK_NEAR(part, forceOn(SearchDepth, sample) / forceOn(0.0, sample) - 1.0, 1e-6);
    PALPATE_CHECK(
      valueOf(stated, "ResponseForce", 60, sample) == valueOf(plain, "ResponseForce", 60, sample));
  }
}
} // namespace

int TestScannedThickness(int, char*[])
{
  testCoverage();
  testNeighbours();
  testHalfSpace();
  return result();
}
