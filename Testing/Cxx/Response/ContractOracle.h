// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ContractOracle_h
#define palpate_testing_ContractOracle_h

#include "ContractCurve.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

namespace palpate::testing
{
/// The curves of a body's response arrays, evaluated by ContractCurve.
class ContractOracle
{
public:
  explicit ContractOracle(vtkPolyData* body, const std::string& name = "Response")
    : Force(body->GetPointData()->GetArray((name + "Force").c_str()))
    , Stiffness(body->GetPointData()->GetArray((name + "Stiffness").c_str()))
    , Normal(body->GetPointData()->GetArray((name + "Normal").c_str()))
    , Range(body->GetPointData()->GetArray((name + "Range").c_str()))
    , Exponent(body->GetFieldData()->GetArray((name + "Exponent").c_str())->GetTuple1(0))
  {
  }

  double force(vtkIdType point, double depth) const
  {
    ContractCurve curve{ this->Exponent, this->Range->GetTuple1(point), {}, {} };
    for (int i = 0; i < this->Force->GetNumberOfComponents(); ++i)
    {
      curve.force.push_back(this->Force->GetComponent(point, i));
      curve.stiffness.push_back(this->Stiffness->GetComponent(point, i));
    }
    return curve.evaluate(depth).force;
  }

  void normal(vtkIdType point, double n[3]) const { this->Normal->GetTuple(point, n); }

private:
  vtkDataArray* Force;
  vtkDataArray* Stiffness;
  vtkDataArray* Normal;
  vtkDataArray* Range;
  double Exponent;
};
} // namespace palpate::testing

#endif
