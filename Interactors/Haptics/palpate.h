/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Palpate from C: load a body, step, reset.
 *
 * For a servo loop that somebody else owns. palpate_step neither allocates, locks, logs nor throws;
 * the other functions may and belong outside the loop. Positions and forces are the device's:
 * metres and newtons in its own frame; what comes back in a palpate_tick is the body's: mm and N in
 * its frame. A body may be shared by any number of contacts and threads; a contact serves one
 * thread and must not outlive its body.
 */
#ifndef PALPATE_H
#define PALPATE_H

/* NOLINTBEGIN(modernize-*): this is C */
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

  typedef struct palpate_body palpate_body;
  typedef struct palpate_contact palpate_contact;

  enum palpate_state
  {
    PALPATE_NONE = 0,
    PALPATE_STICK = 1,
    PALPATE_SLIDE = 2,
    PALPATE_BEYOND_RANGE = 3,
    PALPATE_LOST_AT_BORDER = 4,
    PALPATE_INVALID = 5
  };

  typedef struct palpate_tick
  {
    double device_force[3];  /* on the hand, N, frame of the device: what to send */
    double tip[3];           /* mm, frame of the body, as all that follows */
    double force[3];         /* N, on the tool, before the device's limit */
    double normal_force;     /* N */
    double deflection;       /* mm */
    double normal[3];        /* unit, outward */
    double contact_point[3]; /* mm */
    int triangle;            /* of the body, -1 for none */
    int state;               /* enum palpate_state */
  } palpate_tick;

  /* Loads a file written by `palpate --export`. On failure returns null and writes the reason, cut
   * to error_size with its terminating zero, to error (which may be null). */
  palpate_body* palpate_body_load(const char* path, char* error, size_t error_size);
  void palpate_body_free(palpate_body* body);

  /* A contact with the body: device axes are the body's, 1 m is 1000 mm, and device_force is
   * limited to maximum_force (N) in magnitude. Null if body is null or memory is short. */
  palpate_contact* palpate_contact_new(const palpate_body* body, double maximum_force);
  void palpate_contact_free(palpate_contact* contact);

  /* One tick at a position (m) and a time (s). A position that is not finite gives zero force. */
  void palpate_step(
    palpate_contact* contact, const double position[3], double time, palpate_tick* tick);

  /* Forgets the contact: the next step begins anew. */
  void palpate_reset(palpate_contact* contact);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-*) */

#endif
