// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TipContacts.h"

#include "Mechanics/Checked.h"
#include "Response/Touch/TipOrder.h"
#include "Response/Touch/TipPoses.h"

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
/// Checks the polylines. Returns "" or an error message.
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

/// Checks the times along the polylines of tips that have passed checkLines. Returns "" or an error
/// message.
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
  return firstFault([&] { return checkLines(tips); }, [&] { return checkTimes(tips); },
    [&] { return checkAxes(tips); });
}

void touchWithTips(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit)
{
  const vtkIdType count = tips->GetNumberOfPoints();
  std::vector<char> inHistory(static_cast<std::size_t>(count), 0);
  vtkCellArray* lines = tips->GetLines();
  TipPoses poses(body, tips, indentation);
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
      const ToolPose pose = poses.at(tip);
      if (!times)
      {
        visit(tip, history.update(pose), pose.tip);
        continue;
      }
      const double now = times->GetTuple1(tip);
      visit(tip, history.update(pose, i > 0 ? now - before : 0.0), pose.tip);
      before = now;
    }
  }
  ContactSettings frictionless = settings;
  frictionless.friction.coefficient = 0.0;
  vtkSMPTools::For(0, count,
    [&](vtkIdType first, vtkIdType last)
    {
      ToolContact single(body, frictionless);
      TipPoses start(body, tips, indentation);
      TipOrder order;
      // The results are collected first, and then passed to the visitor in the order of the tips.
      // The visitor writes to many arrays, and writing in this order is faster.
      struct TipResult
      {
        Contact contact;
        Vector3 pressed;
      };
      std::vector<TipResult> results;
      for (vtkIdType block = first; block < last; block += TipOrder::BlockSize)
      {
        order.sort(tips, block, std::min(block + TipOrder::BlockSize, last), inHistory.data());
        results.resize(order.tips().size());
        order.forEach(
          [&](std::size_t k, std::size_t next)
          {
            __builtin_prefetch(order.tips().data() + next);
            for (std::size_t line = 0; line < sizeof(TipResult); line += 64)
            {
              __builtin_prefetch(reinterpret_cast<const char*>(results.data() + next) + line, 1);
            }
            TipResult& at = results[k];
            const ToolPose pose = start.at(order.tips()[k].id, order.tips()[k].position);
            at.pressed = pose.tip;
            single.reset();
            const bool isPress = indentation > 0.0 && body.edges;
            if (isPress)
            {
              single.update(start.onset(order.tips()[k].id, order.tips()[k].position));
            }
            at.contact = single.update(pose);
            if (isPress && !(at.contact.normalForce > 0.0))
            {
              // The face that the tip presses has no force at this point, so all faces are
              // searched.
              single.reset();
              at.contact = single.update(pose);
            }
            if (pose.hasAxis())
            {
              // The second update uses the normal that the first update found.
              at.contact = single.update(pose);
            }
          });
        for (std::size_t k = 0; k < results.size(); ++k)
        {
          visit(order.tips()[k].id, results[k].contact, results[k].pressed);
        }
      }
    });
}
} // namespace palpate
