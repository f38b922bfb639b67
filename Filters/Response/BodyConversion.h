// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * From vtkPolyData to the spans the contact kernel takes.
 *
 * The only place that fetches the response arrays of the data contract
 * (Contact/ResponseContract.h). Errors come back as text that names the array, what was expected
 * and what was found.
 */
#ifndef BodyConversion_h
#define BodyConversion_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/BodyMesh.h"                     // For palpate::BodyMesh
#include "Contact/ContactBody.h"                  // For palpate::ContactBody
#include "Response/Curves/CouplingConversion.h"   // For palpate::describeCoupling
#include "Response/Curves/RelaxationConversion.h" // For palpate::describeRelaxation

#include <cstdint> // For std::int32_t
#include <memory>  // For std::shared_ptr
#include <string>  // For std::string
#include <vector>  // For std::vector

class vtkFieldData;
class vtkPolyData;

namespace palpate
{
/// What is wrong with the cells of a body, or "": it must have triangles, and no other polygons,
/// strips, corners without a point, or more than 2^31 points.
PALPATERESPONSE_EXPORT std::string checkTriangles(vtkPolyData* body);

/// Three point indices per triangle, and x, y, z per point, of a body that has passed
/// checkTriangles.
PALPATERESPONSE_EXPORT std::vector<std::int32_t> copyTriangles(vtkPolyData* body);
PALPATERESPONSE_EXPORT std::vector<double> copyPoints(vtkPolyData* body);

/// The surface of a body that has passed checkTriangles.
PALPATERESPONSE_EXPORT BodyMesh makeBodyMesh(vtkPolyData* body);

/// The point or field data of a body, as the contract has it for an array.
PALPATERESPONSE_EXPORT vtkFieldData* placeOf(const ContractArray& array, vtkPolyData* body);

/// Removes the arrays of a response that have this use.
PALPATERESPONSE_EXPORT void removeArrays(
  vtkPolyData* body, const std::string& name, ContractArray::Use use);

/// Views of the response arrays with prefix `name`, in either form; false and an error if they
/// break the contract.
PALPATERESPONSE_EXPORT bool viewResponse(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error);

/// Views of Validity and Limit of the response with prefix `name`, one value per point; false and
/// an error if one is missing or of another type. Not needed to evaluate a response.
PALPATERESPONSE_EXPORT bool viewValidity(vtkPolyData* body, const std::string& name,
  const float*& validity, const unsigned char*& limit, std::string& error);

/// The same as the kernel keeps it, in the order of the points; null and an error if they break the
/// contract.
PALPATERESPONSE_EXPORT std::unique_ptr<ResponseField> makeResponseField(
  vtkPolyData* body, const std::string& name, std::string& error);

/// Everything a tick needs of a body; null and an error if a part is missing or wrong.
PALPATERESPONSE_EXPORT std::shared_ptr<const ContactBody> makeContactBody(vtkPolyData* body,
  const std::string& name, std::string& error, const BuildProgress& progress = {});

/// The same for a body with the points and triangles of `same` and other responses: the surface is
/// copied, a tenth of the work.
PALPATERESPONSE_EXPORT std::shared_ptr<const ContactBody> makeContactBody(
  vtkPolyData* body, const std::string& name, std::string& error, const ContactBody& same);

/// The description of a response in its field arrays.
struct ResponseDescription
{
  double exponent;
  int samples;
  std::string tool;
  std::string model;
  int modelParts; ///< sum of ModelPart
};

/// Attaches the field arrays Exponent, Samples, Tool, Model, ModelParts and Units.
PALPATERESPONSE_EXPORT void describeResponse(
  vtkPolyData* body, const std::string& name, const ResponseDescription& description);

/// The model of a response, in words and as a sum of ModelPart.
struct ResponseModel
{
  std::string text;
  int parts = 0;

  bool isInSeries() const { return (this->parts & GlobalCompliancePart) != 0; }
  bool isTrueShape() const { return (this->parts & TrueShapePart) != 0; }
};

/// Attaches the field arrays Model and ModelParts.
PALPATERESPONSE_EXPORT void describeModel(
  vtkPolyData* body, const std::string& name, const ResponseModel& model);

/// Attaches the field array Edges.
PALPATERESPONSE_EXPORT void describeEdges(
  vtkPolyData* body, const std::string& name, const EdgeTerms& edges);

/// The model of a response; its parts from the text in older files, which have nothing else.
PALPATERESPONSE_EXPORT ResponseModel responseModel(vtkPolyData* body, const std::string& name);

/// The string in a field array (Tool, Model, Units); "" if there is none.
PALPATERESPONSE_EXPORT std::string responseText(
  vtkPolyData* body, const std::string& name, ResponseArray which);
} // namespace palpate

#endif
