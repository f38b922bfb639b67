// SPDX-License-Identifier: BSD-3-Clause
/**
 * Marks what the kernels' shared libraries export; everything else is hidden.
 *
 * The rule: a class or function out of line in a header that is installed is marked; headers that
 * are not installed (PRIVATE in palpate_add_kernel) mark nothing. Tests reach internals by linking
 * palpateMechanicsInside and the like, archives of the same objects.
 */
#ifndef PalpateExport_h
#define PalpateExport_h

#ifdef __GNUC__
#define PALPATE_EXPORT __attribute__((visibility("default")))
#else
#define PALPATE_EXPORT
#endif

#endif
