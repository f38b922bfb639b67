// SPDX-License-Identifier: BSD-3-Clause
#ifndef RegimeStatement_h
#define RegimeStatement_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkContactTool;
class vtkPolyData;

namespace palpate
{
/// A tool, and the prefix of its response arrays on the compared bodies.
struct ComparedTool
{
  vtkSmartPointer<vtkContactTool> tool;
  std::string responseName;
};

/// The material of a body. The point arrays GlobalCompliance (mm/N) and LayerThickness (mm) of the
/// body are also used if they exist.
struct ComparedMaterial
{
  double youngsModulus = 0.1; ///< MPa
  double poissonRatio = 0.45;
};

/// The results for one tool pressed at one point; see RegimeLaw.h. All values are NaN if there is
/// no stable contact.
struct ToolRegime
{
  double force = 0.0; ///< force by the stored response, N
  double index = 0.0; ///< regime index λ
  double sensitivity = 0.0;
  int verdict = 0;
  double validity = 0.0; ///< validity of the response, mm
};

/// The comparison of several tools pressed to the same depth at one point of a body.
struct RegimeStatement
{
  double deflection = 0.0;       ///< mm
  std::vector<ToolRegime> tools; ///< one per tool, in the order of the tools
  int verdict = 0;               ///< the most cautious verdict of all tools
  double from = 0.0;             ///< smallest depth with the same verdict, mm
  double to = 0.0;               ///< largest depth with the same verdict, mm, within the responses
  double spread = 0.0;           ///< (largest force - smallest force)/mean force
  double validity = 0.0;         ///< depth to which the responses of all tools are valid, mm
};

/// Evaluates a point of a body. `deflection` is in mm; if it is beyond the range of the responses,
/// the range is used. Returns "" or an error message. A call takes a few milliseconds.
std::string judgePoint(vtkPolyData* body, vtkIdType point, const std::vector<ComparedTool>& tools,
  const ComparedMaterial& material, double deflection, RegimeStatement& statement);

// The following functions return the statement as text.
std::string verdictInWords(const RegimeStatement& statement);
/// Describes λ, sensitivity and spread at this depth, and the depths at which the verdict and the
/// responses are valid.
std::string numbersInWords(const RegimeStatement& statement);
} // namespace palpate

#endif
