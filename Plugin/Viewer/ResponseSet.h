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
/// The body of a scene with the responses of all its tools, each with its own prefix of the array
/// names. The prefixes are "Response" for the first tool, which is in use, then "Response2",
/// "Response3" ...
struct ResponseSet
{
  vtkSmartPointer<vtkPolyData> body;
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<std::string> names;
  double seconds = 0.0;      ///< wall-clock time to attach the responses, s
  double bytesPerTool = 0.0; ///< size of the first tool's response arrays, bytes
};

/// The material and the terms from which a response is computed.
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

/// Returns the law of the scene.
ContactLaw lawOf(const ViewerScene& scene);

/// Converts a law to the form of Filters/Laws, which consists of constants and of arrays of the
/// body that override the constants.
BodyMaterial::Constants materialOf(const ContactLaw& law);
MaterialArrays arraysOf(const ContactLaw& law, const ViewerScene& scene, vtkPolyData* body);

/// Returns the prefix of the response arrays of a tool: Response, Response2 ...
std::string responseName(std::size_t tool);

/// Adds the response of a further tool, or the response for another law. Returns "" or an error.
std::string addToolResponse(const ViewerScene& scene, const std::string& tool,
  const ContactLaw& law, double maximumDeflection, ResponseSet& responses);

/// Attaches the responses of all tools as the options require, and writes the files of --save and
/// --export. Returns "" or an error.
std::string prepareResponses(
  const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses);

/// Does the same as prepareResponses for the first tool only. If --save needs all tools, all
/// responses are attached. All tools are checked in any case.
std::string prepareFirstResponse(
  const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses);

/// Attaches the responses that prepareFirstResponse has omitted, only at the given points. Returns
/// "" or an error.
std::string addOtherResponses(const ViewerOptions& options, const ViewerScene& scene,
  const std::vector<vtkIdType>& points, ResponseSet& responses);

/// Copies the body to `body`, and attaches the response of the first tool to the copy, only at the
/// given points. The deflections reach up to `range` mm. `name` is the prefix of the response
/// arrays. `tolerance` replaces the error tolerance of the scene. Returns "" or an error.
std::string attachAtPoints(const ViewerScene& scene, const ResponseSet& responses,
  const std::vector<vtkIdType>& points, const std::string& name, double range, double tolerance,
  vtkSmartPointer<vtkPolyData>& body);

/// Writes a body with all its arrays as a .vtp file, completely or not at all. Returns "" or an
/// error.
std::string saveBody(vtkPolyData* body, const std::string& path);

/// Writes the files of --save and --export. Returns "" or an error.
std::string writeResponses(const ViewerOptions& options, const ResponseSet& responses);

/// Updates an algorithm. Returns the errors that the algorithm reported, without printing them.
std::string updateQuietly(vtkAlgorithm* algorithm);
} // namespace palpate

#endif
