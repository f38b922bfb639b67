// SPDX-License-Identifier: BSD-3-Clause
// Curves of chosen points as a table.
#include "ContractOracle.h"
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkDataObject.h"
#include "vtkResponseCurves.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

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
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "E");
  filter->Update();
  Body output = Body::New();
  output->DeepCopy(filter->GetOutput());
  // Ranges differ where curves were measured; no filter of this version makes such a body.
  output->GetPointData()->GetArray("ResponseRange")->SetTuple1(3, 0.8);
  return output;
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
        PALPATE_CHECK(std::isnan(force)); // no curve there: a gap, not an extrapolation
        continue;
      }
      const double expected = oracle.force(ids[k], depth);
      PALPATE_CHECK_NEAR(force, expected, 1e-13 * expected); // rounding of two orders of summation
    }
  }
  PALPATE_CHECK(table->GetValue(76, 0).ToDouble() == 2.0); // the last row is the range itself
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
} // namespace

int TestResponseCurves(int, char*[])
{
  const Body body = variedBody();
  checkTable(body);
  checkErrors(body);
  return palpate::testing::result();
}
