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
  double tolerance = 0.01;           ///< largest relative error of the force
  /// Deflection at which regime and validity are evaluated, mm; 0 for half of Range.
  double deflection = 0.0;

  /// Name of the array with the body's global compliance (mm/N). If it is given, the form of a
  /// point force is also considered. Tool and material must be those of the response.
  std::string complianceArray;
  vtkSmartPointer<vtkContactTool> tool;
  double youngsModulus = 0.0; ///< MPa
  double poissonRatio = 0.0;
};

/// The body with the simplest form instead of the response, and a sentence that gives the reason
/// for this form.
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
