// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_KernelError_h
#define palpate_KernelError_h

#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ContactKernels.h"

namespace palpate
{
/// Expected error of a contact's compliance due to the elements, mm/N. It combines several parts:
/// by place (ElementError), smaller for a contact wider than the elements; of bending
/// (BendingError); of facets on a curved surface (measured on a ball). If a second mesh gives an
/// estimate, it is combined with these three. Two more parts are the interpolation between the
/// places with known H, and a contact near held points, where two meshes may share the same error.
/// The moduli of mixed cells are not included.
PALPATE_EXPORT double meshError(const ContactKernel& kernel, const KernelSite& site, double radius);

/// Error of a kernel of one term, mm/N, used if an edge or a base leaves too few sources for more
/// terms. H varies with the distance from that limit, between source and point and under the
/// contact.
PALPATE_EXPORT double missedByOne(
  const ContactKernel& kernel, const KernelSite& site, double radius);
} // namespace palpate

#endif
