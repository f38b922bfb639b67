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
/// A request for the simplest form of a response that keeps its forces within a tolerance.
struct LeastFormRequest
{
  vtkSmartPointer<vtkPolyData> body; ///< the body with the response
  std::string name;                  ///< prefix of the response
  double tolerance = 0.01;           ///< relative error of the force
  double deflection = 0.0; ///< deflection at which regime and validity are checked, mm; 0: half of
                           ///< Range

  /// If this array is given, a point force is considered, too. The array is the global compliance
  /// of the body (mm/N). Tool and material are those of the response.
  std::string complianceArray;
  vtkSmartPointer<vtkContactTool> tool;
  double youngsModulus = 0.0; ///< MPa
  double poissonRatio = 0.0;
};

/// The body with the simplest form in place of the response, and the reason for that form in a
/// sentence.
struct LeastForm
{
  vtkSmartPointer<vtkPolyData> body; ///< null after an error
  std::string reason;
  std::string error;
};

/// Finds the simplest form (attachRegime, attachChoice). May run on any thread.
PALPATEINTERACTION_EXPORT LeastForm findLeastForm(const LeastFormRequest& request);
} // namespace palpate

#endif
