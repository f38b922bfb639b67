// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_KernelError_h
#define palpate_KernelError_h

#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ContactKernels.h"

namespace palpate
{
/// Returns the expected error of a contact's compliance due to the elements, mm/N. It combines
/// three parts: the error that is expected for the position (ElementError), which is smaller for a
/// contact wider than the elements; the error of bending (BendingError); and the error of facets on
/// a curved surface, which was measured on a ball. If a second mesh gives an estimate, this
/// estimate is combined with the three parts. Two more parts are added: the error of the
/// interpolation between the positions with known H, and the error of a contact near held points,
/// where two meshes may have the same error. The error of the moduli of mixed cells is not
/// included.
PALPATE_EXPORT double meshError(const ContactKernel& kernel, const KernelSite& site, double radius);

/// Returns the error of a kernel with one term, mm/N. Such a kernel is used if an edge or a base is
/// so close that there are too few sources for more terms. The error is an estimate of the
/// variation of H with the distance from the edge or base, between source and point and under the
/// contact.
PALPATE_EXPORT double missedByOne(
  const ContactKernel& kernel, const KernelSite& site, double radius);
} // namespace palpate

#endif
