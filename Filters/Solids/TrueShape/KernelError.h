// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_KernelError_h
#define palpate_KernelError_h

#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ContactKernels.h"

namespace palpate
{
/// Expected error of a contact's compliance due to the elements, mm/N. It combines these parts: the
/// error expected for the place (ElementError), which is smaller for a contact wider than the
/// elements; the error of bending (BendingError); the error of facets on a curved surface (measured
/// on a ball). If a second mesh gives an estimate, it is combined with these three. Two more parts
/// are added: the error of the interpolation between the places with known H, and that of a contact
/// near held points, where two meshes may share the same error. The moduli of mixed cells are not
/// included.
PALPATE_EXPORT double meshError(const ContactKernel& kernel, const KernelSite& site, double radius);

/// Error of a kernel of one term, mm/N, used if an edge or a base leaves too few sources for more
/// terms. It estimates how much H varies with the distance from that limit, between source and
/// point and under the contact.
PALPATE_EXPORT double missedByOne(
  const ContactKernel& kernel, const KernelSite& site, double radius);
} // namespace palpate

#endif
