/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Palpate from C: load a body, step, reset.
 *
 * For a servo loop of the caller. palpate_step neither allocates, locks, logs nor throws. The other
 * functions may do so; call them outside the loop unless their comment says otherwise. Positions
 * and forces are in the device's frame, in metres and newtons; those in a palpate_tick are in the
 * body's frame, in mm and N, unless noted. Any number of contacts and threads may share a body. A
 * contact serves one thread and must not outlive its body.
 *
 * The first part declares contacts for a loop with a separate mapping and safety. The part that
 * begins with palpate_mapping declares contacts that include both.
 *
 * @code{.c}
 * palpate_tick tick;
 * palpate_body* body = palpate_body_load("body.palpate", reason, sizeof reason);
 * palpate_contact* contact = palpate_contact_new(body, 10.0);     // at most 10 N
 * while (read_position(position, &time))                          // of the device, m and s
 * {
 *   palpate_step(contact, position, time, &tick);
 *   write_force(tick.device_force);                               // to the device, N
 * }
 * palpate_contact_free(contact);
 * palpate_body_free(body);
 * @endcode
 *
 * How this interface may change, so that a program works with any later library of the same soname:
 * - Functions, enumerators and macros are only added. Existing ones keep their names, arguments and
 *   meaning.
 * - A struct keeps its size and the positions of its members. A new member uses space of
 *   `reserved`, and zero in it means the behaviour before the addition. Initialise every input
 *   struct with its palpate_..._default or palpate_..._of, which sets `reserved` to zero. Functions
 *   that can report a reason reject a `reserved` that is not zero. In every output struct
 *   `reserved` is zero.
 * - Each such addition increases PALPATE_API_VERSION by one; palpate.symbols lists the version in
 *   which each function was added. Any other change causes another soname. The soname changes with
 *   the second number of Palpate's version before 1.0, and with the first number after that;
 *   PALPATE_API_VERSION continues.
 */
#ifndef PALPATE_H
#define PALPATE_H

/* NOLINTBEGIN(modernize-*): this is C */
#include <stddef.h>

/*
 * The version of this header. The major number is compared first, then the minor number, then the
 * patch number.
 */
#define PALPATE_VERSION_MAJOR 0
#define PALPATE_VERSION_MINOR 1
#define PALPATE_VERSION_PATCH 0
#define PALPATE_VERSION_STRING "0.1.0"

/* The version of this header's interface, an integer that starts at 1. */
#define PALPATE_API_VERSION 4

#ifdef __GNUC__
#define PALPATE_API __attribute__((visibility("default")))
#else
#define PALPATE_API
#endif

#ifdef __cplusplus
extern "C"
{
#endif

  /* The version of the loaded library ("0.1.0") and its PALPATE_API_VERSION. A program may use
   * everything in its header if the version of the library is not below that of the header. */
  PALPATE_API const char* palpate_version(void);
  PALPATE_API int palpate_api_version(void);

  /* A body with the responses of one tool. */
  typedef struct palpate_body palpate_body;
  /* One tip on a body, and the history of its contact. */
  typedef struct palpate_contact palpate_contact;

  /* State of the contact, the value of palpate_tick.state. */
  enum palpate_state
  {
    PALPATE_NONE = 0,
    PALPATE_STICK = 1,
    PALPATE_SLIDE = 2,
    PALPATE_BEYOND_RANGE = 3,
    PALPATE_LOST_AT_BORDER = 4,
    PALPATE_INVALID = 5,
    PALPATE_TILTED_TOO_FAR = 6 /* since 4: the force is that of the largest tilt of the response */
  };

  /* The method that combines the curves at a triangle's corners into one force. */
  enum palpate_force_form
  {
    PALPATE_PAPER = 0,
    PALPATE_NORMALIZED_DIRECTION = 1,
    PALPATE_ENERGY_CONSISTENT = 2
  };

  /* The surface onto which the tip is projected. */
  enum palpate_contact_surface
  {
    PALPATE_FACETS = 0,
    PALPATE_SMOOTH = 1
  };

  /* The friction model of a contact. */
  enum palpate_friction_model
  {
    PALPATE_ELASTO_PLASTIC = 0,
    PALPATE_DAHL = 1,
    PALPATE_SHAPE_DERIVED = 2
  };

  /* The settings of a contact. Initialise the struct with palpate_settings_default. The forms,
   * surfaces and models are described in ContactSettings.h and vtkToolContactProbe.h. */
  typedef struct palpate_settings
  {
    int force_form;      /* enum palpate_force_form */
    int contact_surface; /* enum palpate_contact_surface */
    int friction_model;  /* enum palpate_friction_model */
    /* Coulomb's coefficient of friction, finite and >= 0. The default 0 means no friction. */
    double friction_coefficient;
    /*
     * Tangential stiffness of a sticking contact, N/mm, finite and > 0. A loop with the period T on
     * a device with the damping b is stable only up to the stiffness 2b/T. Not used by
     * PALPATE_SHAPE_DERIVED.
     */
    double tangential_stiffness;
    /*
     * Used only by PALPATE_ELASTO_PLASTIC, as fractions of the sliding limit. Below
     * friction_breakaway (0 to 1) there is no creep. At the second fraction (> 0 and not less than
     * the first one) half of a further displacement is creep.
     */
    double friction_breakaway;
    double friction_stick_radius;
    /* Poisson's ratio of the body, 0 to 0.5. Used only by PALPATE_SHAPE_DERIVED. */
    double poisson_ratio;
    double reserved[8]; /* zero */
  } palpate_settings;

  /* The input and result of one step. */
  typedef struct palpate_tick
  {
    double device_force[3];  /* force to send, on the hand, N, frame of the device */
    double tip[3];           /* mm, frame of the body, as all vectors below */
    double force[3];         /* N, on the tool, before the device's limit: normal and friction */
    double friction[3];      /* N, on the tool, tangential */
    double normal_force;     /* N, along normal */
    double deflection;       /* mm */
    double normal[3];        /* unit, outward */
    double contact_point[3]; /* mm */
    int triangle;            /* index of the body's triangle; -1 without contact */
    int state;               /* enum palpate_state */
    double memory;           /* N, memory part of normal_force if the body relaxes (since 3) */
    double torque[3];        /* N mm, on the tool about its tip (since 4, as tilt) */
    double tilt;             /* rad, between the tool's axis and normal; 0 if the axis is unknown */
    double reserved[3];
  } palpate_tick;

  /* Loads a file written by `palpate --export`. On failure returns null and writes the reason to
   * error. The reason is truncated to error_size bytes with its terminating zero. error may be
   * null. */
  PALPATE_API palpate_body* palpate_body_load(const char* path, char* error, size_t error_size);
  PALPATE_API void palpate_body_free(palpate_body* body);

  /* Creates a contact with the body. The device axes are those of the body, 1 m is 1000 mm, and the
   * magnitude of device_force is limited to maximum_force (N). Returns null if body is null or
   * there is not enough memory. */
  PALPATE_API palpate_contact* palpate_contact_new(const palpate_body* body, double maximum_force);

  /* Sets the default settings, which are those of palpate_contact_new. */
  PALPATE_API void palpate_settings_default(palpate_settings* settings);

  /* Creates a contact with other settings (the defaults if settings is null). Also returns null if
   * a setting is out of its range. Then the name of the setting, its range and its value are
   * written to error as in palpate_body_load. */
  PALPATE_API palpate_contact* palpate_contact_new_with(const palpate_body* body,
    double maximum_force, const palpate_settings* settings, char* error, size_t error_size);
  PALPATE_API void palpate_contact_free(palpate_contact* contact);

  /* Computes one tick at a position (m) and a time (s). The force is zero if the position is not
   * finite. */
  PALPATE_API void palpate_step(
    palpate_contact* contact, const double position[3], double time, palpate_tick* tick);

  /* Computes one tick with the tool's axis. The axis is in the device frame, from the tip to the
   * hand, and need not be normalised. A zero axis is unknown; the tool is then along the body's
   * normal, as in palpate_step. The force is zero if the axis is not finite. (since 4) */
  PALPATE_API void palpate_step_pose(palpate_contact* contact, const double position[3],
    const double axis[3], double time, palpate_tick* tick);

  /* Resets the contact, so that the next step starts without history. */
  PALPATE_API void palpate_reset(palpate_contact* contact);

  /* Mapping from the device to the body: x_body = rotation (1000 scale x_device) + translation. The
   * magnitude of forces is unchanged, so that the stiffness at the hand is scale times the
   * stiffness of the body. */
  typedef struct palpate_mapping
  {
    double rotation[9];    /* row by row; its columns are the axes of the device; orthonormal */
    double translation[3]; /* mm */
    double scale;          /* > 0 */
    /*
     * Nonzero for a planar device. Such a device has two axes, x and y, and moves in the plane that
     * these axes span through translation. Only the component of a force in this plane acts on the
     * hand.
     */
    int planar;
    double reserved[4];
  } palpate_mapping;

  /* Sets the mapping of palpate_contact_new: the device axes are those of the body, and 1 m is 1000
   * mm. */
  PALPATE_API void palpate_mapping_default(palpate_mapping* mapping);

  /* Sets translation and scale of a mapping and keeps its rotation. The scale is the smallest one
   * for which the workspace contains the body with a free margin around it. workspace contains the
   * half extents of the workspace, m. margin is in mm. Returns 1 on success. On failure returns 0,
   * writes the reason to error and leaves the mapping unchanged. */
  PALPATE_API int palpate_mapping_fit(palpate_mapping* mapping, const palpate_body* body,
    const double workspace[3], double margin, char* error, size_t error_size);

  /* A device's specification by its manufacturer. */
  typedef struct palpate_device
  {
    double maximum_force;      /* N */
    double maximum_stiffness;  /* N/m, of a sampled spring that comes to rest at the rate below */
    double maximum_force_rate; /* N/s, may be infinite */
    double rate;               /* Hz, of the loop */
    double sample_time_out;    /* s without a reading until the device is lost; may be infinite */
    double delay; /* since version 2; largest sum of the delays of readings and forces, s */
    /*
     * Since version 4. maximum_torque is the largest torque about the tip, N m; it is 0 if the
     * device outputs no torque. maximum_torsional_stiffness is the largest stiffness of a sampled
     * torsion spring, N m/rad; if it is 0, 0.5 is used.
     */
    double maximum_torque;
    double maximum_torsional_stiffness;
    double reserved[1];
  } palpate_device;

  /* Sets the default specification: 10 N, 1500 N/m, any force rate, 1000 Hz, 20 ms. */
  PALPATE_API void palpate_device_default(palpate_device* device);

  /* The links that a force passes before it is sent, in this order. Initialise the struct with
   * palpate_safety_of. */
  typedef struct palpate_safety
  {
    int gate;          /* nonzero: no force until the tip has been outside once */
    double entry_ramp; /* s, rise time of the force of the first contact; 0: no ramp */
    /*
     * Factor by which all forces are multiplied, > 0 to 1. Compared tools must have the same
     * factor, so that the device's limits do not change the ratios of their forces.
     */
    double force_factor;
    int cap_stiffness; /* nonzero: the stiffness is limited to maximum_stiffness */
    double maximum_stiffness;
    double maximum_force_rate;
    double maximum_force;
    int control_passivity;  /* nonzero: the device returns no more energy than was put in */
    double period;          /* s, > 0, of the loop */
    double sample_time_out; /* > 0 */
    double delay; /* since version 2; delay of the device, s, >= 0; for control_passivity */
    double maximum_torque; /* since version 4, like the members below; N m; 0: no torque is sent */
    double maximum_torsional_stiffness; /* N m/rad; 0: 0.5 is used */
    double maximum_torque_rate;         /* N m/s; 0: no limit */
    double reserved[4];
  } palpate_safety;

  /* Sets all links active, with the limits of a device (the default device if device is null). */
  PALPATE_API void palpate_safety_of(const palpate_device* device, palpate_safety* safety);

  /* The links of the safety chain; palpate_full_tick.acted reports which links changed the force
   * between palpate_full_tick.ideal_force and the force sent. */
  enum palpate_safety_link
  {
    PALPATE_NOT_FINITE = 1,
    PALPATE_GATE = 2,
    PALPATE_FIT = 4,
    PALPATE_STIFFNESS_CAP = 8,
    PALPATE_SLEW = 16,
    PALPATE_MAGNITUDE = 32,
    PALPATE_PASSIVITY = 64,
    PALPATE_WATCHDOG = 128,
    PALPATE_NO_SAMPLE = 256,
    PALPATE_STOPPED = 512
  };

  /* Creates a contact with mapping, safety and settings; each of them may be null for its default.
   * clutch_buttons is a mask: while one of these buttons is pressed, the tip does not move and the
   * hand moves freely. With 0 there is no clutch. The contact shares the ownership of its body, so
   * that the caller may free the body earlier. Returns null if a number is out of its range or
   * there is not enough memory, and writes the reason to error. */
  PALPATE_API palpate_contact* palpate_contact_new_safe(const palpate_body* body,
    const palpate_mapping* mapping, const palpate_safety* safety, const palpate_settings* settings,
    unsigned int clutch_buttons, char* error, size_t error_size);

  /* A reading of a device, in the device's frame. */
  typedef struct palpate_sample
  {
    double position[3];   /* m */
    double velocity[3];   /* m/s; zero if the device does not measure it */
    unsigned int buttons; /* bit i: button i is pressed */
    int valid;            /* 0: the device has no reading; the force is then zero */
    int fresh;            /* 0: no new reading, the last one is repeated */
    /*
     * Since version 4. orientation contains w, x, y, z of the unit quaternion that rotates the
     * tool's own frame into the device frame. The z axis of the tool's frame is the shaft from tip
     * to hand. All components are zero if the orientation is unknown. angular_velocity is in rad/s,
     * or zero if unknown.
     */
    double orientation[4];
    double angular_velocity[3];
    double reserved[1];
  } palpate_sample;

  /* Sets valid and fresh to 1 and all other members to zero. */
  PALPATE_API void palpate_sample_default(palpate_sample* sample);

  /* The input and result of one step of a contact with mapping and safety. */
  typedef struct palpate_full_tick
  {
    palpate_tick tick;       /* contact and force sent, as from palpate_step */
    double velocity[3];      /* of the hand, mm/s, frame of the body, as the forces below */
    double ideal_force[3];   /* N, before the safety chain */
    double applied_force[3]; /* N, tick.device_force in the frame of the body */
    double force_factor;     /* ratio of applied to ideal force, by PALPATE_FIT */
    double
      scene_share; /* fraction of the newest scene in the ideal force; 1 except while changing */
    unsigned int scene; /* index of the newest scene: number of preceding changes */
    unsigned int acted; /* sum of enum palpate_safety_link */
    int valid;          /* the sample was valid and finite */
    int clutched;       /* the tip does not move while the hand moves */
    /*
     * Since version 2. Time, s, for which device_force may be held if no tick follows; may be
     * infinite. A device that ends its force after this time returns no more energy than was put
     * in.
     */
    double hold_time;
    double
      device_torque[3]; /* since version 4; on the hand, about the tip, N m, frame of the device */
    double ideal_torque[3]; /* N mm, before the safety chain, frame of the body */
    double reserved[1];
  } palpate_full_tick;

  /* For the loop: computes one tick of any contact with a complete sample of a device. As for
   * palpate_step, time must increase. palpate_step is equivalent to this function with a valid,
   * fresh sample without velocity and buttons. */
  PALPATE_API void palpate_step_sample(
    palpate_contact* contact, const palpate_sample* sample, double time, palpate_full_tick* tick);

  /* For the loop: prefetches the memory that the next step reads if the hand continues its motion.
   * Optional; to be called after the force is sent and before the loop waits for the next tick. It
   * changes no result and takes 50 ns to a few microseconds. Without this call a step on a new part
   * of a large body takes a third longer. */
  PALPATE_API void palpate_foresee(const palpate_contact* contact);

  /* For the loop: ends the force from the next step until palpate_start is called. */
  PALPATE_API void palpate_stop(palpate_contact* contact);
  PALPATE_API void palpate_start(palpate_contact* contact);

  /* Another body, tool or material, or other settings, for a contact that may be touching. */
  typedef struct palpate_scene palpate_scene;

  /* Creates a scene, which shares the ownership of its body. force_factor (> 0 to 1) belongs to the
   * scene and applies in addition to palpate_safety.force_factor. On failure returns null and
   * writes the reason to error. */
  PALPATE_API palpate_scene* palpate_scene_new(const palpate_body* body,
    const palpate_settings* settings, double force_factor, char* error, size_t error_size);
  /* Frees a scene that was not passed to a contact, or all scenes that palpate_take_retired
   * returned. */
  PALPATE_API void palpate_scene_free(palpate_scene* scene);

  /* For the loop: passes a scene to the contact. The force of the contact changes to that of the
   * scene within 50 ms, without a jump. A scene that is passed during a change waits; if several
   * scenes wait, only the newest is used. A null scene has no effect. */
  PALPATE_API void palpate_change(palpate_contact* contact, palpate_scene* scene);
  /* For the loop: returns the scenes that the contact no longer needs, or null. Free them outside
   * the loop by one call of palpate_scene_free. Scenes that are not taken are freed with the
   * contact. */
  PALPATE_API palpate_scene* palpate_take_retired(palpate_contact* contact);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-*) */

#endif
