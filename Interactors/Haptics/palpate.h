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

  /* How the curves of a triangle's corners become one force. */
  enum palpate_force_form
  {
    PALPATE_PAPER = 0,
    PALPATE_NORMALIZED_DIRECTION = 1,
    PALPATE_ENERGY_CONSISTENT = 2
  };

  /* The surface the tip is projected on. */
  enum palpate_contact_surface
  {
    PALPATE_FACETS = 0,
    PALPATE_SMOOTH = 1
  };

  enum palpate_friction_model
  {
    PALPATE_ELASTO_PLASTIC = 0,
    PALPATE_DAHL = 1,
    PALPATE_SHAPE_DERIVED = 2
  };

  /* How a contact feels. Begin with palpate_settings_default: members may be added. What the forms,
   * surfaces and models are stands in ContactSettings.h and vtkToolContactProbe.h. */
  typedef struct palpate_settings
  {
    int force_form;      /* enum palpate_force_form */
    int contact_surface; /* enum palpate_contact_surface */
    int friction_model;  /* enum palpate_friction_model */
    /* Coulomb's, finite and >= 0; 0, the default: no friction. */
    double friction_coefficient;
    /* Of the stuck contact, N/mm, finite and > 0. A loop of period T at a device of damping b is
     * stable only up to 2b/T. Not used by PALPATE_SHAPE_DERIVED. */
    double tangential_stiffness;
    /* PALPATE_ELASTO_PLASTIC only: share of the sliding limit below which nothing creeps, 0 to 1;
     * and share at which half of a further displacement creeps, > 0 and no less than the former. */
    double friction_breakaway;
    double friction_stick_radius;
    /* Of the body, 0 to 0.5. PALPATE_SHAPE_DERIVED only. */
    double poisson_ratio;
  } palpate_settings;

  typedef struct palpate_tick
  {
    double device_force[3];  /* on the hand, N, frame of the device: what to send */
    double tip[3];           /* mm, frame of the body, as all that follows */
    double force[3];         /* N, on the tool, before the device's limit: normal and friction */
    double friction[3];      /* N, on the tool, tangential */
    double normal_force;     /* N, along normal */
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

  /* The default settings: those of palpate_contact_new. */
  void palpate_settings_default(palpate_settings* settings);

  /* The same with other settings (null: the default). Null also if one of them is out of its range;
   * the reason, naming it, its range and its value, goes to error as in palpate_body_load. */
  palpate_contact* palpate_contact_new_with(const palpate_body* body, double maximum_force,
    const palpate_settings* settings, char* error, size_t error_size);
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
