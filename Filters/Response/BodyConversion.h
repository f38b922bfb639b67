// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Conversion from vtkPolyData to the data of the contact kernel.
 *
 * Only this code fetches the response arrays of the data contract (Contact/ResponseContract.h). An
 * error message names the array, the expected form and the form found.
 */
#ifndef BodyConversion_h
#define BodyConversion_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/BodyMesh.h"    // For palpate::BodyMesh
#include "Contact/ContactBody.h" // For palpate::ContactBody

#include <cstdint> // For std::int32_t
#include <memory>  // For std::shared_ptr
#include <string>  // For std::string
#include <vector>  // For std::vector

class vtkFieldData;
class vtkPolyData;

namespace palpate
{
/// Checks the cells of a body, which must have only triangles. These are errors: other polygons,
/// strips, corners that refer to a missing point, and more than 2^31 points. Returns "" if the
/// cells are valid, else an error message.
PALPATERESPONSE_EXPORT std::string checkTriangles(vtkPolyData* body);

/// copyTriangles returns three point indices per triangle, and copyPoints returns x, y, z per
/// point. The body must have passed checkTriangles.
PALPATERESPONSE_EXPORT std::vector<std::int32_t> copyTriangles(vtkPolyData* body);
PALPATERESPONSE_EXPORT std::vector<double> copyPoints(vtkPolyData* body);

/// Returns the surface of a body that has passed checkTriangles.
PALPATERESPONSE_EXPORT BodyMesh makeBodyMesh(vtkPolyData* body);

/// Returns the point data or the field data of a body, depending on where the contract places the
/// array.
PALPATERESPONSE_EXPORT vtkFieldData* placeOf(const ContractArray& array, vtkPolyData* body);

/// Removes all arrays of the response `name` whose ContractArray::Use is `use`.
PALPATERESPONSE_EXPORT void removeArrays(
  vtkPolyData* body, const std::string& name, ContractArray::Use use);

/// Removes all arrays of a response, in any form and with any term.
PALPATERESPONSE_EXPORT void removeResponse(vtkPolyData* body, const std::string& name);

/// Sets `arrays` to views of the response arrays with prefix `name`, in either form. Returns false
/// and an error if the arrays break the contract.
PALPATERESPONSE_EXPORT bool viewResponse(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error);

/// Sets `validity` and `limit` to views of the arrays Validity and Limit of the response with
/// prefix `name`, one value per point. Returns false and an error if one is missing or has another
/// type. The two arrays are not needed to evaluate a response.
PALPATERESPONSE_EXPORT bool viewValidity(vtkPolyData* body, const std::string& name,
  const float*& validity, const unsigned char*& limit, std::string& error);

/// Creates the kernel's copy of the response, in the order of the points. Returns null and an error
/// if the arrays break the contract.
PALPATERESPONSE_EXPORT std::unique_ptr<ResponseField> makeResponseField(
  vtkPolyData* body, const std::string& name, std::string& error);

/// Creates all data of a body that one tick needs. Returns null and an error if a part of the data
/// is missing or invalid.
PALPATERESPONSE_EXPORT std::shared_ptr<const ContactBody> makeContactBody(vtkPolyData* body,
  const std::string& name, std::string& error, const BuildProgress& progress = {});

/// Creates the data of a body with the points and triangles of `same` and other responses. The two
/// bodies share the surface; therefore this call takes a tenth of the time. `isMultiple` states
/// that the curves are the curves of `same` times one factor.
PALPATERESPONSE_EXPORT std::shared_ptr<const ContactBody> makeContactBody(vtkPolyData* body,
  const std::string& name, std::string& error, const ContactBody& same, bool isMultiple = false);

/// The field arrays that describe a response.
struct ResponseDescription
{
  double exponent;
  int samples;
  std::string tool;
  std::string model;
  int modelParts; ///< sum of the ModelPart values of the model
};

/// Attaches the field arrays Exponent, Samples, Tool, Model, ModelParts and Units.
PALPATERESPONSE_EXPORT void describeResponse(
  vtkPolyData* body, const std::string& name, const ResponseDescription& description);

/// The model of a response, as text and as a sum of ModelPart.
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

/// Name of the point array with the motion of the body, which vtkElasticCompliance computes by
/// finite elements.
constexpr const char* CouplingModesName = "CouplingModes";

/// Attaches the field arrays RelaxationStrength and RelaxationTime. Replaces existing ones.
PALPATERESPONSE_EXPORT void describeRelaxation(
  vtkPolyData* body, const std::string& name, const PronySeries& series);

/// Returns the model of a response. Older files store only the text. For such a file, the parts are
/// derived from the text.
PALPATERESPONSE_EXPORT ResponseModel responseModel(vtkPolyData* body, const std::string& name);

/// Returns the text in a field array of the response (Tool, Model or Units). Returns "" if the body
/// does not have the array.
PALPATERESPONSE_EXPORT std::string responseText(
  vtkPolyData* body, const std::string& name, ResponseArray which);
} // namespace palpate

#endif
