// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Terms/LawTerm.h"

#include "Contact/Edges/EdgeLaw.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/ArrayFetch.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/AutomaticTerms.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
constexpr int EdgeComponents = componentsOf(contractOf(ResponseArray::Edges), 0, 0);

EdgeTerms edgesOf(const TermBody& response)
{
  const double range = response.request.deflection;
  if (!response.material)
  {
    EdgeTerms edges = edgeTermsOf(response.tool, range, 0.5);
    edges.isInCurves = true;
    return edges;
  }
  const MaterialRange& bounds = response.material->range();
  EdgeTerms edges = edgeTermsOf(response.tool, range, 0.5 * (bounds.leastRatio + bounds.mostRatio));
  const bool isLayered = bounds.hasLayers() && !bounds.hasHalfSpace;
  edges.extent = isLayered ? std::min(response.depth, bounds.layers.thickest) : response.depth;
  edges.isInCurves = (response.material->modelParts() & GlobalCompliancePart) != 0;
  return edges;
}

void addEdges(vtkPolyData* body, const std::string& name, const EdgeTerms& edges)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(arrayName(name, ResponseArray::Edges).c_str());
  array->SetNumberOfComponents(EdgeComponents);
  const std::array<double, EdgeComponents> values = { edges.exponent, edges.radius,
    edges.poissonRatio, edges.extent, edges.isInCurves ? 1.0 : 0.0 };
  array->InsertNextTuple(values.data());
  body->GetFieldData()->AddArray(array);
}

/// The effect of sharp edges on contacts near them. The array of the term is Edges. Without this
/// array, edges do not change the force. Curves for the true shape of a body already contain the
/// effect, except beyond the edge.
class EdgeTerm : public LawTerm
{
public:
  bool isAsked(const LawRequest& request) const override;
  std::string make(const TermBody& response, vtkPolyData* output) const override;
  /// Keeps the term if a sharp edge is close enough to affect a contact, because a contact at any
  /// depth can leave the body over an edge.
  std::string need(AutomaticTerms& choice) const override;
  bool view(vtkPolyData* body, const std::string& name, ResponseArrays& arrays,
    std::string& error) const override;
  void describe(
    vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const override;
};
} // namespace

bool EdgeTerm::isAsked(const LawRequest& request) const
{
  return request.terms.edges;
}

std::string EdgeTerm::make(const TermBody& response, vtkPolyData* output) const
{
  addEdges(output, response.request.responseName, edgesOf(response));
  return {};
}

std::string EdgeTerm::need(AutomaticTerms& choice) const
{
  const auto& nearest = choice.pressed.shape.edge;
  if (!choice.terms.edges || !nearest || choice.terms.errorTolerance == 0.0)
  {
    return {};
  }
  bool areNear = false;
  for (std::size_t i = 0; choice.hasPiece() && i < choice.pressed.points && !areNear; ++i)
  {
    areNear = nearest(i).distance < NearEdge::Far;
  }
  choice.terms.edges = choice.ranks.any(areNear);
  choice.addReason(choice.terms.edges
      ? "sharp edges have an effect"
      : "no sharp edge is within reach of a contact: edges are left out");
  return {};
}

void EdgeTerm::describe(
  vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const
{
  if (arrays.edges.areFelt())
  {
    addEdges(body, name, arrays.edges);
  }
}

bool EdgeTerm::view(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error) const
{
  EdgeTerms& edges = arrays.edges;
  const std::string full = arrayName(name, ResponseArray::Edges);
  vtkDataArray* array = body->GetFieldData()->GetArray(full.c_str());
  if (!array)
  {
    return true;
  }
  if (array->GetNumberOfComponents() != EdgeComponents || array->GetNumberOfTuples() != 1)
  {
    error = joined("field array '", full, "' must have ", EdgeComponents,
      " components and one tuple, but is ", shapeOf(array));
    return false;
  }
  edges.exponent = array->GetComponent(0, 0);
  edges.radius = array->GetComponent(0, 1);
  edges.poissonRatio = array->GetComponent(0, 2);
  edges.extent = array->GetComponent(0, 3);
  edges.isInCurves = array->GetComponent(0, 4) != 0.0;
  error = faultOfEdges(edges);
  if (!error.empty())
  {
    error = "field array '" + full + "': " + error;
  }
  return error.empty();
}

const LawTerm& edgeTerm()
{
  static const EdgeTerm term;
  return term;
}
} // namespace palpate
