// SPDX-License-Identifier: BSD-3-Clause
// Curves of chosen points as a table: chosen by their ids or by selections of all kinds, of one or
// several responses.
#include "ContractOracle.h"
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkResponseCurves.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
using namespace palpate::testing;

Body variedBody()
{
  Body body = planeBody(5.0, 2);
  pointArray(body, "E", [](vtkIdType i) { return 0.1 * static_cast<double>(i + 1); });
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(makeTool("sphere:5"));
  makePlain(filter);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "E");
  filter->Update();
  Body output = Body::New();
  output->DeepCopy(filter->GetOutput());
  // One point has another range, as measured curves might. No filter of this version makes such a
  // body.
  output->GetPointData()->GetArray("ResponseRange")->SetTuple1(3, 0.8);
  return output;
}

/// The columns with the bounds of the force by its error come after all forces. They are absent if
/// there is no error or if they are switched off.
void checkBand()
{
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(planeBody(5.0, 2));
  filter->SetTool(makeTool("sphere:5"));
  filter->SetPoissonRatio(0.3);
  vtkNew<vtkResponseCurves> curves;
  curves->SetInputConnection(filter->GetOutputPort());
  curves->AddPointId(4);
  curves->AddPointId(0);
  curves->SetNumberOfRows(9);
  curves->Update();
  vtkTable* table = curves->GetOutput();
  PALPATE_CHECK(table->GetNumberOfColumns() == 7);
  PALPATE_CHECK_TEXT(table->GetColumnName(1), "Response at point 4 (N)");
  PALPATE_CHECK_TEXT(table->GetColumnName(3), "Response at point 4, least (N)");
  PALPATE_CHECK_TEXT(table->GetColumnName(6), "Response at point 0, most (N)");
  // The last row is the last sample of the curve.
  vtkDataArray* stored = filter->GetOutput()->GetPointData()->GetArray("ResponseError");
  const double error = stored->GetComponent(4, 7);
  const double force = table->GetValue(8, 1).ToDouble();
  PALPATE_CHECK(error > 0.02);
  PALPATE_CHECK_NEAR(table->GetValue(8, 3).ToDouble(), (1.0 - error) * force, 1e-12);
  PALPATE_CHECK_NEAR(table->GetValue(8, 4).ToDouble(), (1.0 + error) * force, 1e-12);
  curves->ErrorBandOff();
  curves->Update();
  PALPATE_CHECK(curves->GetOutput()->GetNumberOfColumns() == 3);
}

void checkTable(vtkPolyData* body)
{
  vtkNew<vtkResponseCurves> curves;
  Messages messages(curves);
  curves->SetInputData(body);
  curves->Update();
  PALPATE_CHECK(messages.none() && curves->GetOutput()->GetNumberOfColumns() == 0);

  const std::vector<vtkIdType> ids = { 7, 3, 0 };
  for (const vtkIdType id : ids)
  {
    curves->AddPointId(id);
  }
  curves->SetNumberOfRows(77);
  curves->Update();
  vtkTable* table = curves->GetOutput();
  PALPATE_CHECK(table->GetNumberOfColumns() == 4 && table->GetNumberOfRows() == 77);
  PALPATE_CHECK_TEXT(table->GetColumnName(0), "Deflection", "mm");
  const ContractOracle oracle(body);
  for (vtkIdType row = 0; row < 77; ++row)
  {
    const double depth = table->GetValue(row, 0).ToDouble();
    PALPATE_CHECK_NEAR(depth, 2.0 * static_cast<double>(row) / 76.0, 1e-15);
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      const auto column = static_cast<vtkIdType>(k) + 1;
      const double force = table->GetValue(row, column).ToDouble();
      if (ids[k] == 3 && depth > static_cast<double>(0.8F))
      {
        PALPATE_CHECK(std::isnan(force)); // beyond the range there is a gap, not an extrapolation
        continue;
      }
      const double expected = oracle.force(ids[k], depth);
      PALPATE_CHECK_NEAR(force, expected, 1e-13 * expected); // the sum has another order
    }
  }
  PALPATE_CHECK(table->GetValue(76, 0).ToDouble() == 2.0); // the last row is at the range itself
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    PALPATE_CHECK_TEXT(table->GetColumnName(static_cast<vtkIdType>(k) + 1), "Response",
      std::to_string(ids[k]).c_str(), "N");
  }
  curves->RemoveAllPointIds();
  curves->Update();
  PALPATE_CHECK(curves->GetOutput()->GetNumberOfColumns() == 0);
}

void checkErrors(vtkPolyData* body)
{
  vtkNew<vtkResponseCurves> curves;
  Messages messages(curves);
  curves->SetInputData(body);
  for (const vtkIdType wrong : { -1, 9 })
  {
    curves->RemoveAllPointIds();
    curves->AddPointId(0);
    curves->AddPointId(wrong);
    curves->Update();
    PALPATE_CHECK_TEXT(messages.takeErrors(), "Point", std::to_string(wrong).c_str());
    PALPATE_CHECK(curves->GetOutput()->GetNumberOfColumns() == 0);
  }
  curves->RemoveAllPointIds();
  curves->AddPointId(4);
  curves->Update();
  PALPATE_CHECK(messages.none() && curves->GetOutput()->GetNumberOfColumns() == 2);
  vtkUnsignedCharArray::SafeDownCast(body->GetPointData()->GetArray("ResponseStatus"))
    ->SetValue(4, 1);
  body->GetPointData()->GetArray("ResponseStatus")->Modified();
  curves->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Point 4", "no response");
  curves->SetResponseName("Other");
  curves->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'OtherSamples'", "missing");
}

template <class Array>
vtkSmartPointer<vtkSelection> select(
  int content, int field, const std::vector<double>& values, int components = 1)
{
  vtkNew<Array> list;
  list->SetNumberOfComponents(components);
  for (const double value : values)
  {
    list->InsertNextValue(value);
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(content);
  node->SetFieldType(field);
  node->SetSelectionList(list);
  auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

/// The ids in the column names of one response.
std::vector<int> pointsOf(vtkTable* table, const std::string& response)
{
  std::vector<int> ids;
  const std::string head = response + " at point ";
  for (vtkIdType i = 1; i < table->GetNumberOfColumns(); ++i)
  {
    const std::string name = table->GetColumnName(i);
    if (name.compare(0, head.size(), head) == 0)
    {
      ids.push_back(std::stoi(name.substr(head.size())));
    }
  }
  return ids;
}

/// The points of the plane are a grid of 3 by 3 from (-5, -5) to (5, 5), row by row in y.
void checkSelections(vtkPolyData* body)
{
  using Ids = std::vector<int>;
  vtkNew<vtkResponseCurves> curves;
  Messages messages(curves);
  curves->SetInputData(body);
  curves->AddPointId(999); // ignored if there is a selection
  const auto expect = [&](vtkSelection* selection, const Ids& ids)
  {
    curves->SetInputData(1, selection);
    curves->Update();
    PALPATE_CHECK(messages.none());
    PALPATE_CHECK(pointsOf(curves->GetOutput(), "Response") == ids);
  };
  expect(
    select<vtkIdTypeArray>(vtkSelectionNode::INDICES, vtkSelectionNode::POINT, { 7, 3 }), { 3, 7 });
  const auto place = select<vtkDoubleArray>(
    vtkSelectionNode::LOCATIONS, vtkSelectionNode::POINT, { 4.9, -5.0, 0.0 }, 3);
  place->GetNode(0u)->GetProperties()->Set(vtkSelectionNode::EPSILON(), 0.2);
  expect(place, { 2 });
  const auto thresholds = select<vtkDoubleArray>(
    vtkSelectionNode::THRESHOLDS, vtkSelectionNode::POINT, { 0.35, 0.65 }, 2);
  thresholds->GetNode(0u)->GetSelectionList()->SetName("E");
  expect(thresholds, { 3, 4, 5 }); // E = 0.1 (i + 1)
  // The region x > -1 and y > -1 as eight corners of four numbers each.
  std::vector<double> corners;
  for (const double x : { -1.0, 9.0 })
  {
    for (const double y : { -1.0, 9.0 })
    {
      for (const double z : { 1.0, -1.0 }) // near plane, far plane
      {
        corners.insert(corners.end(), { x, y, z, 1.0 });
      }
    }
  }
  expect(select<vtkDoubleArray>(vtkSelectionNode::FRUSTUM, vtkSelectionNode::POINT, corners, 4),
    { 4, 5, 7, 8 });
  vtkIdType count = 0;
  const vtkIdType* corner = nullptr;
  body->GetCellPoints(0, count, corner);
  Ids ids(corner, corner + count);
  std::sort(ids.begin(), ids.end());
  expect(select<vtkIdTypeArray>(vtkSelectionNode::INDICES, vtkSelectionNode::CELL, { 0 }), ids);
  vtkNew<vtkSelection> nothing;
  curves->SetInputData(1, nothing);
  curves->Update();
  PALPATE_CHECK(messages.none() && curves->GetOutput()->GetNumberOfColumns() == 0);

  const auto all = select<vtkIdTypeArray>(
    vtkSelectionNode::INDICES, vtkSelectionNode::POINT, { 0, 1, 2, 3, 4, 5, 6, 7, 8 });
  curves->SetMaximumNumberOfPoints(3);
  curves->SetInputData(1, all);
  curves->Update();
  PALPATE_CHECK((pointsOf(curves->GetOutput(), "Response") == Ids{ 0, 4, 8 }));
  PALPATE_CHECK_TEXT(messages.warnings(), "9 points", "3 of them", "Maximum Number Of Points");
  messages.clear();

  Body partly = Body::New();
  partly->DeepCopy(body);
  vtkDataArray* status = partly->GetPointData()->GetArray("ResponseStatus");
  status->SetTuple1(4, 1.0);
  curves->SetMaximumNumberOfPoints(20);
  curves->SetInputData(0, partly);
  curves->Update();
  PALPATE_CHECK((pointsOf(curves->GetOutput(), "Response") == Ids{ 0, 1, 2, 3, 5, 6, 7, 8 }));
  PALPATE_CHECK_TEXT(messages.warnings(), "1 of 9", "left out");
  messages.clear();
  status->Fill(1.0);
  partly->Modified();
  curves->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "None of the 9", "'Response'");
  PALPATE_CHECK(curves->GetOutput()->GetNumberOfColumns() == 0);
}

/// Two responses of one body in one chart: each has the same curve as alone, over the deflections
/// of the response with the larger range.
void checkSeveral()
{
  vtkNew<vtkToolContactResponse> second;
  vtkNew<vtkToolContactResponse> first;
  makePlain(first);
  makePlain(second);
  first->SetInputData(planeBody(5.0, 2));
  first->SetTool(makeTool("sphere:5"));
  second->SetInputConnection(first->GetOutputPort());
  second->SetTool(makeTool("cone:60"));
  second->SetMaximumDeflection(3.0);
  second->SetResponseName("Cone");
  second->Update();
  vtkNew<vtkResponseCurves> curves;
  Messages messages(curves);
  curves->SetInputConnection(second->GetOutputPort());
  curves->AddPointId(4);
  curves->AddMoreResponseName("Cone");
  curves->AddMoreResponseName("Response"); // a name given twice counts once
  curves->SetNumberOfRows(31);
  curves->Update();
  PALPATE_CHECK(messages.none());
  vtkTable* table = curves->GetOutput();
  PALPATE_CHECK(table->GetNumberOfColumns() == 3);
  const ContractOracle sphere(second->GetOutput());
  const ContractOracle cone(second->GetOutput(), "Cone");
  for (vtkIdType row = 0; row < 31; ++row)
  {
    const double depth = table->GetValue(row, 0).ToDouble();
    PALPATE_CHECK_NEAR(depth, 0.1 * static_cast<double>(row), 1e-15);
    const double here = table->GetValueByName(row, "Response at point 4 (N)").ToDouble();
    if (depth > 2.0)
    {
      PALPATE_CHECK(std::isnan(here));
    }
    else
    {
      PALPATE_CHECK_NEAR(here, sphere.force(4, depth), 1e-13 * here);
    }
    const double other = table->GetValueByName(row, "Cone at point 4 (N)").ToDouble();
    PALPATE_CHECK_NEAR(other, cone.force(4, depth), 1e-13 * other);
  }
  curves->AddMoreResponseName("Other");
  curves->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'OtherSamples'", "missing");
  curves->RemoveAllMoreResponseNames();
  curves->SetResponseName("Cone");
  curves->Update();
  PALPATE_CHECK(messages.none() && curves->GetOutput()->GetNumberOfColumns() == 2);
}
} // namespace

int TestResponseCurves(int, char*[])
{
  checkBand();
  const Body body = variedBody();
  checkTable(body);
  checkSelections(body);
  checkSeveral();
  checkErrors(body);
  return palpate::testing::result();
}
