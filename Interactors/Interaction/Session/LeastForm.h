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
/// A response whose simplest form that keeps its forces is wanted.
struct LeastFormRequest
{
  vtkSmartPointer<vtkPolyData> body; ///< with the response
  std::string name;                  ///< its prefix
  double tolerance = 0.01;           ///< of the force, relative
  double deflection = 0.0; ///< mm, where regime and validity are looked at; 0: half of Range

  /// A point force is considered where the body gives way as a whole: then this array has its
  /// compliance (mm/N), and tool and material are those of the response.
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
