// SPDX-License-Identifier: BSD-3-Clause
/**
 * From vtkPolyData to the spans the contact kernel takes.
 *
 * The only place that knows how the response arrays of the data contract are named and stored.
 * Errors come back as text that names the array, what was expected and what was found.
 */
#ifndef BodyConversion_h
#define BodyConversion_h

#include "palpateResponseModule.h" // For export macro

#include "ContactBody.h" // For palpate::ContactBody

#include <memory> // For std::shared_ptr
#include <string> // For std::string

class vtkPolyData;

namespace palpate
{
/// What is wrong with the cells of a body, or "": it must have triangles, and no other polygons,
/// strips, or more points than 2^31.
PALPATERESPONSE_EXPORT std::string checkTriangles(vtkPolyData* body);

/// The surface of a body that has passed checkTriangles.
PALPATERESPONSE_EXPORT BodyMesh makeBodyMesh(vtkPolyData* body);

/// The response arrays with prefix `name`, both forms; null and an error if they break the
/// contract.
PALPATERESPONSE_EXPORT std::unique_ptr<ResponseField> makeResponseField(
  vtkPolyData* body, const std::string& name, std::string& error);

/// Everything a tick needs of a body; null and an error if a part is missing or wrong.
PALPATERESPONSE_EXPORT std::shared_ptr<const ContactBody> makeContactBody(
  vtkPolyData* body, const std::string& name, std::string& error);

/// The string in field array <name><suffix> (Tool, Model, Units); "" if there is none.
PALPATERESPONSE_EXPORT std::string responseText(
  vtkPolyData* body, const std::string& name, const char* suffix);
} // namespace palpate

#endif
