// SPDX-License-Identifier: BSD-3-Clause
/*
 * Computes the force of a tool that is pressed straight into a body of quadratic tetrahedra
 * (DirectContact).
 *
 *   palpateDirectContact BODY.vtu YOUNG POISSON TOOL DEPTH X Y Z NX NY NZ
 *
 * BODY is an output of vtkGradedBody. The tool is pressed at X Y Z by DEPTH mm along the unit
 * vector N. Prints two forces in N, at small strain: with all pressures along the mean normal, and
 * with each pressure along its own normal.
 */
#include "Mechanics/Tools/ToolSpecification.h"
#include "Solids/TrueShape/DirectContact.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace
{
using namespace palpate;

/// Returns the reason of a failure, or "".
std::string take(vtkUnstructuredGrid* grid, const ElasticMaterial& material, ElasticBody& body)
{
  ElasticBodyInput input;
  input.mesh.nodes.resize(3, grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, input.mesh.nodes.data() + 3 * i);
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(c, count, ids);
    if (grid->GetCellType(c) != VTK_QUADRATIC_TETRA)
    {
      return "there are cells other than quadratic tetrahedra";
    }
    VolumeElement element;
    element.kind = ElementKind::QuadraticTetrahedron;
    std::copy(ids, ids + count, element.nodes.begin());
    input.mesh.elements.push_back(element);
  }
  vtkDataArray* fixed = grid->GetPointData()->GetArray("Fixed");
  if (fixed == nullptr)
  {
    return "there is no array 'Fixed'";
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    input.fixed.push_back(static_cast<unsigned char>(fixed->GetTuple1(i)));
  }
  input.materials = { material };
  std::string fault = body.assemble(std::move(input));
  fault = fault.empty() ? body.analyse(StiffnessFactor::Kind::Automatic) : fault;
  return fault.empty() ? body.factorise() : fault;
}
} // namespace

int main(int count, char** arguments)
{
  if (count != 12)
  {
    std::fprintf(
      stderr, "usage: %s BODY.vtu YOUNG POISSON TOOL DEPTH X Y Z NX NY NZ\n", arguments[0]);
    return 1;
  }
  std::array<double, 12> value{};
  for (std::size_t i = 2; i < value.size(); ++i)
  {
    value[i] = std::atof(arguments[i]);
  }
  ToolSpecification specification;
  std::string fault;
  ElasticBody body;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(arguments[1]);
  reader->Update();
  if (parseTool(arguments[4], specification, fault))
  {
    fault = take(reader->GetOutput(), { value[2], value[3] }, body);
  }
  if (!fault.empty())
  {
    std::fprintf(stderr, "%s: %s\n", arguments[1], fault.c_str());
    return 1;
  }
  const auto tool = makeTool(specification);
  const DirectPlace at{ { value[6], value[7], value[8] },
    Eigen::Vector3d(value[9], value[10], value[11]).normalized() };
  const DirectContact contact(body, *tool, at, value[5]);
  for (const Pushed pushed : { Pushed::TogetherAlongTheMean, Pushed::EachAlongItsOwn })
  {
    std::printf("%.9g\n", contact.at(value[5], pushed).force);
  }
  return 0;
}
