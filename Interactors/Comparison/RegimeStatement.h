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
/// A tool, and the prefix of its responses on the compared bodies.
struct ComparedTool
{
  vtkSmartPointer<vtkContactTool> tool;
  std::string responseName;
};

/// The material of a body. Its point arrays GlobalCompliance (mm/N) and LayerThickness (mm) are
/// also used, if present.
struct ComparedMaterial
{
  double youngsModulus = 0.1; ///< MPa
  double poissonRatio = 0.45;
};

/// Results for one tool pressed at one point: see RegimeLaw.h. NaN if there is no stable contact.
struct ToolRegime
{
  double force = 0.0; ///< N, from the stored response
  double index = 0.0; ///< λ
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
  double spread = 0.0;           ///< (largest - smallest force)/mean
  double validity = 0.0;         ///< mm: the responses of all tools are valid down to this depth
};

/// Evaluates a point of a body; returns an error message, or "". A `deflection` (mm) beyond the
/// range of the responses is replaced by the range. Takes a few milliseconds.
std::string judgePoint(vtkPolyData* body, vtkIdType point, const std::vector<ComparedTool>& tools,
  const ComparedMaterial& material, double deflection, RegimeStatement& statement);

// The following functions return the statement as text.
std::string verdictInWords(const RegimeStatement& statement);
/// λ, sensitivity and spread at this depth, and the depths at which the verdict and the responses
/// are valid.
std::string numbersInWords(const RegimeStatement& statement);
} // namespace palpate

#endif
