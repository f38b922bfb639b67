// SPDX-License-Identifier: BSD-3-Clause
/**
 * Marks the classes and functions that Palpate's shared libraries export. All other symbols are
 * hidden.
 *
 * Rule: in an installed header, mark each function and each class that is defined in a source file.
 * Headers that are not installed (PRIVATE in palpate_add_kernel) have no marks. Tests access
 * internal functions by linking palpateMechanicsInside and similar archives of the same objects.
 */
#ifndef PalpateExport_h
#define PalpateExport_h

#ifdef __GNUC__
#define PALPATE_EXPORT __attribute__((visibility("default")))
#else
#define PALPATE_EXPORT
#endif

#endif
