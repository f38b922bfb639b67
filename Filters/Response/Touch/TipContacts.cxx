// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TipContacts.h"

#include "Response/Touch/TipOrder.h"
#include "Contact/TriangleSearch.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace palpate
{
namespace
{
/// The tip moved inward along the blended normal at its closest point.
Vector3 pressedTip(
  const ContactBody& body, TriangleSearch& search, const Vector3& tip, double indentation)
{
  if (indentation == 0.0)
  {
    return tip;
  }
  const SurfacePoint nearest = search.closestLocal(body.surface.toLocal(tip));
  if (nearest.triangle < 0)
  {
    return tip;
  }
  Vector3 normal = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    normal += nearest.projection.weights[k] *
      body.response.normal(body.surface.corners(nearest.triangle)[static_cast<std::size_t>(k)]);
  }
  const double length = normal.norm();
  return length > 0.0 ? Vector3(tip - indentation / length * normal) : tip;
}

/// What is wrong with the polylines, or "".
std::string checkLines(vtkPolyData* tips)
{
  vtkCellArray* lines = tips->GetLines();
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(line, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (points[i] < 0 || points[i] >= tips->GetNumberOfPoints())
      {
        return "polyline " + std::to_string(line) + " goes through point " +
          std::to_string(points[i]) + ", but there are " +
          std::to_string(tips->GetNumberOfPoints()) + " points";
      }
    }
  }
  return {};
}

/// What is wrong with the times along the polylines of tips that have passed checkLines, or "".
std::string checkTimes(vtkPolyData* tips)
{
  vtkCellArray* lines = tips->GetLines();
  vtkAbstractArray* given = tips->GetPointData()->GetAbstractArray("Time");
  if (!given || lines->GetNumberOfCells() == 0)
  {
    return {};
  }
  auto* times = vtkDataArray::SafeDownCast(given);
  if (!times || times->GetNumberOfComponents() != 1 ||
    times->GetNumberOfTuples() != tips->GetNumberOfPoints())
  {
    return "the point array 'Time' must hold one number per point";
  }
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(line, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const double time = times->GetTuple1(points[i]);
      const double before = i > 0 ? times->GetTuple1(points[i - 1]) : time;
      if (!std::isfinite(time) || time < before)
      {
        std::ostringstream text;
        text << "the point array 'Time' is " << time << " at point " << points[i];
        if (std::isfinite(time))
        {
          text << ", after " << before << " at point " << points[i - 1];
        }
        text << " (polyline " << line << "), but must be finite and not decrease along a polyline";
        return text.str();
      }
    }
  }
  return {};
}
} // namespace

std::string checkTips(vtkPolyData* tips)
{
  const std::string fault = checkLines(tips);
  return fault.empty() ? checkTimes(tips) : fault;
}

void touchWithTips(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit)
{
  const vtkIdType count = tips->GetNumberOfPoints();
  std::vector<char> inHistory(static_cast<std::size_t>(count), 0);
  vtkCellArray* lines = tips->GetLines();
  TriangleSearch search(body.tree);
  vtkDataArray* times = tips->GetPointData()->GetArray("Time");
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(line, size, points);
    ToolContact history(body, settings);
    double before = 0.0;
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType tip = points[i];
      inHistory[static_cast<std::size_t>(tip)] = 1;
      Vector3 position;
      tips->GetPoint(tip, position.data());
      const Vector3 pressed = pressedTip(body, search, position, indentation);
      if (!times)
      {
        visit(tip, history.update(pressed), pressed);
        continue;
      }
      const double now = times->GetTuple1(tip);
      visit(tip, history.update(pressed, i > 0 ? now - before : 0.0), pressed);
      before = now;
    }
  }
  ContactSettings frictionless = settings;
  frictionless.friction.coefficient = 0.0;
  vtkSMPTools::For(0, count,
    [&](vtkIdType first, vtkIdType last)
    {
      ToolContact single(body, frictionless);
      TriangleSearch start(body.tree);
      TipOrder order;
      // What is felt goes to its place in one piece, and from there, in the order of the tips, to
      // the many arrays of the visitor.
      struct Felt
      {
        Contact contact;
        Vector3 pressed;
      };
      std::vector<Felt> felt;
      for (vtkIdType block = first; block < last; block += TipOrder::BlockSize)
      {
        order.sort(tips, block, std::min(block + TipOrder::BlockSize, last), inHistory.data());
        felt.resize(order.tips().size());
        order.forEach(
          [&](std::size_t k, std::size_t next)
          {
            __builtin_prefetch(order.tips().data() + next);
            for (std::size_t line = 0; line < sizeof(Felt); line += 64)
            {
              __builtin_prefetch(reinterpret_cast<const char*>(felt.data() + next) + line, 1);
            }
            Felt& at = felt[k];
            at.pressed = pressedTip(body, start, order.tips()[k].position, indentation);
            single.reset();
            at.contact = single.update(at.pressed);
          });
        for (std::size_t k = 0; k < felt.size(); ++k)
        {
          visit(order.tips()[k].id, felt[k].contact, felt[k].pressed);
        }
      }
    });
}
} // namespace palpate
