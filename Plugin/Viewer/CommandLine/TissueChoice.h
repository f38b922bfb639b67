// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TissueChoice_h
#define palpate_TissueChoice_h

#include <string>

namespace palpate
{
/// The value of --tissue: a label of a segmentation and the material of this label.
struct TissueChoice
{
  double label = 0.0;
  double youngsModulus = 0.0; ///< MPa
  double poissonRatio = 0.0;
};

/// Reads a tissue from "LABEL:MPA:NU". Returns "" or an error.
std::string readTissue(const std::string& text, TissueChoice& tissue);
} // namespace palpate

#endif
