// SPDX-License-Identifier: BSD-3-Clause
#ifndef LeastForm_h
#define LeastForm_h

#include "palpateInteractionModule.h" // For export macro

#include "vtkContactTool.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
/// A request for the simplest form of a response that keeps its forces.
struct LeastFormRequest
{
  vtkSmartPointer<vtkPolyData> body; ///< with the response
  std::string name;                  ///< its prefix
  double tolerance = 0.01;           ///< of the force, relative
  double deflection = 0.0; ///< mm, at which regime and validity are checked; 0: half of Range

  /// A point force is considered if this array is given, with the body's global compliance (mm/N);
  /// tool and material are then those of the response.
  std::string complianceArray;
  vtkSmartPointer<vtkContactTool> tool;
  double youngsModulus = 0.0; ///< MPa
  double poissonRatio = 0.0;
};

/// The body with that form in place of the response, and why, in a sentence.
struct LeastForm
{
  vtkSmartPointer<vtkPolyData> body; ///< null after an error
  std::string reason;
  std::string error;
};

/// By attachRegime and attachChoice. On any thread.
PALPATEINTERACTION_EXPORT LeastForm findLeastForm(const LeastFormRequest& request);
} // namespace palpate

#endif
