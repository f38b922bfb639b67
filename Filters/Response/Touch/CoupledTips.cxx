// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/CoupledTips.h"

#include "Contact/Coupled/CoupledContacts.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"
#include "Response/Touch/TipPoses.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace palpate
{
namespace
{
using Line = std::vector<vtkIdType>;

std::vector<Line> linesOf(vtkPolyData* tips)
{
  std::vector<Line> lines;
  for (vtkIdType line = 0; line < tips->GetLines()->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    tips->GetLines()->GetCellAtId(line, size, points);
    lines.emplace_back(points, points + size);
  }
  return lines;
}

vtkDataArray* timesOf(vtkPolyData* tips)
{
  return tips->GetPointData()->GetArray("Time");
}

/// Groups the tips of polylines that press at the same time, by Time or by index. Each group has
/// one entry per polyline. The entry is -1 if the tool of the polyline is absent.
std::map<double, Line> stepsOf(vtkPolyData* tips, const std::vector<Line>& lines)
{
  vtkDataArray* times = timesOf(tips);
  std::map<double, Line> steps;
  for (std::size_t line = 0; line < lines.size(); ++line)
  {
    for (std::size_t i = 0; i < lines[line].size(); ++i)
    {
      const vtkIdType tip = lines[line][i];
      const double when = times ? times->GetTuple1(tip) : static_cast<double>(i);
      steps.try_emplace(when, lines.size(), -1).first->second[line] = tip;
    }
  }
  return steps;
}

/// Groups the single points by time.
std::map<double, Line> groupsOf(vtkPolyData* tips, const std::vector<Line>& lines)
{
  std::vector<char> inHistory(static_cast<std::size_t>(tips->GetNumberOfPoints()), 0);
  for (const Line& line : lines)
  {
    for (const vtkIdType tip : line)
    {
      inHistory[static_cast<std::size_t>(tip)] = 1;
    }
  }
  vtkDataArray* times = timesOf(tips);
  std::map<double, Line> groups;
  for (vtkIdType tip = 0; tip < tips->GetNumberOfPoints(); ++tip)
  {
    if (!inHistory[static_cast<std::size_t>(tip)])
    {
      const double when = times ? times->GetTuple1(tip) : 0.0;
      groups[std::isnan(when) ? -Infinity : when].push_back(tip);
    }
  }
  return groups;
}

/// Checks the times of polylines that press at the same time. Returns "" or an error message.
std::string checkSteps(vtkPolyData* tips, const std::vector<Line>& lines)
{
  vtkDataArray* times = timesOf(tips);
  const auto timeOf = [times](vtkIdType tip) { return times->GetTuple1(tip); };
  for (std::size_t line = 0; line < lines.size(); ++line)
  {
    for (std::size_t i = 1; i < lines[line].size(); ++i)
    {
      if (timeOf(lines[line][i]) == timeOf(lines[line][i - 1]))
      {
        return joined("polyline ", line, " has two points at Time ", timeOf(lines[line][i]), ", ",
          lines[line][i - 1], " and ", lines[line][i],
          ": it is not known which of them presses with the other tips");
      }
    }
  }
  for (const auto& [time, step] : stepsOf(tips, lines))
  {
    for (std::size_t line = 0; line < lines.size(); ++line)
    {
      if (step[line] < 0 && !lines[line].empty() && time > timeOf(lines[line].front()) &&
        time < timeOf(lines[line].back()))
      {
        return joined("polyline ", line, " has no point at Time ", time,
          ", at which another polyline has one, between its first and its last point: the position "
          "of its tool is not known");
      }
    }
  }
  return {};
}

/// Copies the results of tips that press at the same time to the rows of these tips. An index of -1
/// marks an absent tip.
void storeCoupling(const CoupledContacts& contacts, const Line& tips, vtkDoubleArray* stiffness,
  std::vector<double>* errors)
{
  for (std::size_t i = 0; errors && i < tips.size(); ++i)
  {
    if (tips[i] >= 0)
    {
      (*errors)[static_cast<std::size_t>(tips[i])] = contacts.pointForceError(i);
    }
  }
  if (!stiffness)
  {
    return;
  }
  const Eigen::MatrixXd rows = contacts.stiffness();
  for (std::size_t i = 0; i < tips.size(); ++i)
  {
    for (std::size_t j = 0; tips[i] >= 0 && j < tips.size(); ++j)
    {
      stiffness->SetTypedComponent(tips[i], static_cast<int>(j),
        rows(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
}

void touchAlong(const ContactBody& body, vtkPolyData* tips, const std::vector<Line>& lines,
  const ContactSettings& settings, TipPoses& poses, const TipVisitor& visit,
  vtkDoubleArray* stiffness, std::vector<double>* errors)
{
  const bool isInTime = timesOf(tips) != nullptr;
  CoupledContacts contacts(body, settings, lines.size());
  std::vector<ToolPose> at(lines.size(), ToolPose(Vector3::Constant(NotANumber)));
  double before = 0.0;
  bool isFirst = true;
  for (const auto& [when, step] : stepsOf(tips, lines))
  {
    for (std::size_t line = 0; line < lines.size(); ++line)
    {
      at[line] = step[line] < 0 ? ToolPose(Vector3::Constant(NotANumber)) : poses.at(step[line]);
    }
    const std::vector<Contact>& felt = isInTime
      ? contacts.settle(at.data(), isFirst ? 0.0 : when - before)
      : contacts.settle(at.data());
    for (std::size_t line = 0; line < lines.size(); ++line)
    {
      if (step[line] >= 0)
      {
        visit(step[line], felt[line], at[line].tip);
      }
    }
    storeCoupling(contacts, step, stiffness, errors);
    before = when;
    isFirst = false;
  }
}
} // namespace

std::string checkCoupledTips(vtkPolyData* tips)
{
  const std::vector<Line> lines = linesOf(tips);
  if (lines.size() > CoupledContacts::Most)
  {
    return joined("there are ", lines.size(), " polylines, but at most ", CoupledContacts::Most,
      " tools press at once");
  }
  vtkAbstractArray* given = tips->GetPointData()->GetAbstractArray("Time");
  vtkDataArray* times = timesOf(tips);
  if (given &&
    (!times || times->GetNumberOfComponents() != 1 ||
      times->GetNumberOfTuples() != tips->GetNumberOfPoints()))
  {
    return "the point array 'Time' must hold one number per point";
  }
  for (const auto& [time, group] : groupsOf(tips, lines))
  {
    if (time == -Infinity)
    {
      return joined("the point array 'Time' is ", times->GetTuple1(group.front()), " at point ",
        group.front(), ": it is not known with which tips it presses");
    }
    if (group.size() > CoupledContacts::Most)
    {
      return joined("there are ", group.size(), " single points at one time, but at most ",
        CoupledContacts::Most, " tools press at once");
    }
  }
  return times ? checkSteps(tips, lines) : std::string();
}

void touchTogether(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit, vtkDoubleArray* stiffness,
  std::vector<double>* errors)
{
  if (errors)
  {
    errors->assign(static_cast<std::size_t>(tips->GetNumberOfPoints()), 0.0);
  }
  const std::vector<Line> lines = linesOf(tips);
  const std::map<double, Line> groups = groupsOf(tips, lines);
  if (stiffness)
  {
    std::size_t most = lines.size();
    for (const auto& [time, group] : groups)
    {
      most = std::max(most, group.size());
    }
    stiffness->SetNumberOfComponents(static_cast<int>(std::max<std::size_t>(most, 1)));
    stiffness->SetNumberOfTuples(tips->GetNumberOfPoints());
    stiffness->Fill(0.0);
  }
  TipPoses poses(body, tips, indentation);
  if (!lines.empty())
  {
    touchAlong(body, tips, lines, settings, poses, visit, stiffness, errors);
  }
  ContactSettings frictionless = settings;
  frictionless.friction.coefficient = 0.0;
  for (const auto& [time, group] : groups)
  {
    CoupledContacts contacts(body, frictionless, group.size());
    std::vector<ToolPose> at;
    std::vector<ToolPose> onset;
    for (const vtkIdType tip : group)
    {
      Vector3 position;
      tips->GetPoint(tip, position.data());
      at.push_back(poses.at(tip, position));
      onset.push_back(poses.onset(tip, position));
    }
    if (indentation > 0.0 && body.edges)
    {
      contacts.settle(onset.data());
    }
    const std::vector<Contact>& felt = contacts.settle(at.data());
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      visit(group[i], felt[i], at[i].tip);
    }
    storeCoupling(contacts, group, stiffness, errors);
  }
}
} // namespace palpate
