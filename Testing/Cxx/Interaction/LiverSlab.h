// SPDX-License-Identifier: BSD-3-Clause
// A relaxing slab of liver, pressed by a sphere at 1 mm/s, and the expected values of its loop
// (Data/Reference/rate/loops_paper.csv: p = 0.5, 0.5, tau = 0.5, 10 s).
#ifndef palpate_testing_LiverSlab_h
#define palpate_testing_LiverSlab_h

#include "LiveChartChecks.h"

#include "vtkHapticSession.h"

#include <algorithm>
#include <vector>

namespace palpate::testing
{
constexpr double SlabPress = 5.0;  // mm deep, at 1 mm/s
constexpr double SlabAbove = 0.25; // mm above the surface, at the beginning and the end
constexpr double SlabDuration = 2.0 * (SlabPress + SlabAbove);

/// A slab 10 mm thick, bonded, incompressible.
inline Body liverSlab(double radius, bool relaxes = true)
{
  const auto filter = filterOf(planeBody(20.0, 4), "paraboloid:1", SlabPress);
  filter->GetTool()->SetRadius(radius);
  filter->SetYoungsModulus(0.01);
  filter->SetPoissonRatio(0.5);
  filter->SetLayerThickness(10.0);
  filter->SetNumberOfSamples(16);
  if (relaxes)
  {
    filter->AddRelaxation(0.5, 0.5);
    filter->AddRelaxation(0.5, 10.0);
  }
  filter->Update();
  return filter->GetOutput();
}

inline vtkSmartPointer<vtkHapticSession> slabSession(vtkPolyData* slab)
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  session->SetBody(slab);
  session->GetDevice()->SetPath(timedPath({ { 0.3, 0.2, SlabAbove, 0.0 },
    { 0.3, 0.2, -SlabPress, SlabPress + SlabAbove }, { 0.3, 0.2, SlabAbove, SlabDuration } }));
  return session;
}

/// Values of a loop. The loop is a press and its return, given as rows of deflection and force in
/// order of time.
struct Loop
{
  double peak = 0.0; ///< N
  double work = 0.0; ///< work on the way in, N mm
  double loss = 0.0; ///< energy loss, N mm
  double end = 0.0;  ///< deflection at which contact ends, mm

  explicit Loop(const std::vector<Row>& rows)
  {
    for (std::size_t i = 1; i < rows.size(); ++i)
    {
      const double way = rows[i].first - rows[i - 1].first;
      const double done = 0.5 * (rows[i].second + rows[i - 1].second) * way;
      this->peak = std::max(this->peak, rows[i].second);
      this->work += way > 0.0 ? done : 0.0;
      this->loss += done;
    }
    this->end = rows.empty() ? 0.0 : rows.back().first;
  }
};

/// Compares with `peak` and `loss` of loops_paper.csv. `felt` is the loop of the total force,
/// `slow` the loop of the slow force.
inline void checkLoop(const Loop& felt, const Loop& slow, double peak, double loss)
{
  PALPATE_CHECK_NEAR(felt.loss / felt.work, loss, 0.01);
  PALPATE_CHECK_NEAR(felt.peak / slow.peak, peak, 0.01);
  PALPATE_CHECK_NEAR(felt.end / SlabPress, 0.1417, 0.005);
}
} // namespace palpate::testing

#endif
