// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseSet_h
#define palpate_ResponseSet_h

#include "Response/BodyLaws.h"
#include "ViewerScene.h"

#include "vtkAlgorithm.h"
#include "vtkContactTool.h"

#include <string>
#include <vector>

namespace palpate
{
/// The body of a scene with the responses of all its tools, each with its own prefix: "Response"
/// for the first tool, which is in use, then "Response2", "Response3" ...
struct ResponseSet
{
  vtkSmartPointer<vtkPolyData> body;
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<std::string> names;
  double seconds = 0.0;      ///< wall time to attach the responses
  double bytesPerTool = 0.0; ///< size of the first tool's response arrays
};

/// The material data of a response.
struct ContactLaw
{
  double youngsModulus = 0.0; ///< MPa
  double poissonRatio = 0.0;
  LayerChoice layer;

  bool operator==(const ContactLaw& other) const
  {
    return this->youngsModulus == other.youngsModulus && this->poissonRatio == other.poissonRatio &&
      this->layer == other.layer;
  }
};

/// The law of the scene.
ContactLaw lawOf(const ViewerScene& scene);

/// The law in the form of Filters/Laws: constants, and the arrays of the body that override the
/// constants.
BodyMaterial::Constants materialOf(const ContactLaw& law);
MaterialArrays arraysOf(const ContactLaw& law, const ViewerScene& scene, vtkPolyData* body);

/// Prefix of the arrays of a tool's response: Response, Response2 ...
std::string responseName(std::size_t tool);

/// Adds the response of one more tool, or the response for another law. Returns an error, or "".
std::string addToolResponse(const ViewerScene& scene, const std::string& tool,
  const ContactLaw& law, double maximumDeflection, ResponseSet& responses);

/// Attaches the responses of all tools as the options require, and writes the files of --save and
/// --export. Returns "" or an error.
std::string prepareResponses(
  const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses);

/// Does the same as prepareResponses, but only for the first tool, unless --save needs all tools.
/// All tools are checked.
std::string prepareFirstResponse(
  const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses);

/// Attaches the responses that prepareFirstResponse left out, at these points only. Returns "" or
/// an error.
std::string addOtherResponses(const ViewerOptions& options, const ViewerScene& scene,
  const std::vector<vtkIdType>& points, ResponseSet& responses);

/// Attaches the response of the first tool at these points only, up to `range` mm, to a copy of the
/// body, under the prefix `name`. `tolerance` replaces the error tolerance of the scene. Returns ""
/// or an error.
std::string attachAtPoints(const ViewerScene& scene, const ResponseSet& responses,
  const std::vector<vtkIdType>& points, const std::string& name, double range, double tolerance,
  vtkSmartPointer<vtkPolyData>& body);

/// Writes a body with all its arrays as a .vtp file, completely or not at all. Returns "" or an
/// error.
std::string saveBody(vtkPolyData* body, const std::string& path);

/// Writes the files of --save and --export. Returns an error, or "".
std::string writeResponses(const ViewerOptions& options, const ResponseSet& responses);

/// Updates an algorithm. Returns the errors that it reported; they are not printed.
std::string updateQuietly(vtkAlgorithm* algorithm);
} // namespace palpate

#endif
