// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_KernelError_h
#define palpate_KernelError_h

#include "Solids/TrueShape/ContactKernels.h"

namespace palpate
{
/// What the elements let expect of the error of a contact's compliance, mm/N: by its place
/// (ElementError), less of a contact wider than they are; of what bends (BendingError); of facets
/// on a curved surface (measured on a ball): all these as a second mesh tells, too; of what lies
/// between the places where H is known; and of a contact that comes near what is held, which two
/// meshes may miss alike. Not what the moduli of mixed cells do.
double meshError(const ContactKernel& kernel, const KernelSite& site, double radius);

/// What a kernel of one term leaves out, mm/N, where an edge or a base left too few sources for
/// more: H varies by its distance, between the source and the point, and under the contact.
double missedByOne(const ContactKernel& kernel, const KernelSite& site, double radius);
} // namespace palpate

#endif
