/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * The device's side of Palpate's force reports, in C99 for a microcontroller. The functions neither
 * allocate nor wait, and use no library functions except memcpy, memset and sqrtf. PROTOCOL.md
 * describes the reports byte by byte.
 *
 * The firmware uses palpate_hid_report_descriptor as its HID report descriptor, and these calls:
 *
 * @code{.c}
 * palpate_hid_start(&hid, 6.0f, 20000);              // at start: at most 6 N, held for 20 ms
 * palpate_hid_describe(&what_i_am, 0, report);       // the feature report
 * palpate_hid_receive(&hid, report, length, now);    // for each report from the host
 * palpate_hid_force(&hid, now, force);               // each tick: apply it by the motors
 * palpate_hid_torque(&hid, now, torque);             // if there are motors for it
 * palpate_hid_state(&hid, now, &reading, report);    // and send this report
 * @endcode
 *
 * `now` is a clock in microseconds that does not decrease. Calls must not interrupt one another: if
 * receive is called from an interrupt, disable this interrupt during the other calls.
 */
#ifndef PALPATE_HID_H
#define PALPATE_HID_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

#define PALPATE_HID_REPORT_SIZE 64
#define PALPATE_HID_DESCRIPTOR_SIZE 29

  /* The descriptor has the vendor page 0xFF00 and the usage 0x50. It defines an input, an output
   * and a feature report, unnumbered and of 64 bytes each. */
  extern const uint8_t palpate_hid_report_descriptor[PALPATE_HID_DESCRIPTOR_SIZE];

  /* The device's specification, as given by its manufacturer. SI units. */
  typedef struct palpate_hid_description
  {
    bool outputs_force;
    bool planar;              /* moves only in its xy plane */
    float maximum_force;      /* N */
    float maximum_stiffness;  /* N/m, of a spring rendered at `rate`: damping times `rate` */
    float maximum_force_rate; /* N/s, may be infinite */
    float maximum_damping;    /* N s/m */
    float half_extents[3];    /* half extents of the workspace about 0, m */
    float rate;               /* states per second, Hz */
    float sample_time_out;    /* s; longest time without a state before the device counts as lost */
    /* UTF-8, padded with zeros; if outputs_torque is true, only 3 bytes are sent */
    char name[16];
    bool outputs_torque;  /* torque about the tool's tip; if false, the values below are 0 */
    float maximum_torque; /* N m */
    float maximum_torsional_stiffness; /* N m/rad, of a torsion spring rendered at `rate` */
    float maximum_torque_rate;         /* N m/s, may be infinite */
  } palpate_hid_description;

  /* One reading of the sensors. SI units. */
  typedef struct palpate_hid_reading
  {
    float position[3]; /* m */
    float velocity[3]; /* m/s; zeros if not known */
    uint32_t buttons;  /* bit i: button i is down */
    bool fault;        /* the reading is not reliable: the host sends no force */
    /* w, x, y, z of the unit quaternion that rotates the tool's frame into the device frame; z of
     * the tool's frame is the shaft from tip to hand; all zero if unknown */
    float orientation[4];
  } palpate_hid_reading;

  /* The state of the protocol in the device. The counters are for inspection. */
  typedef struct palpate_hid
  {
    float maximum_force;       /* N: a stronger force is scaled down to it */
    uint32_t longest_watchdog; /* us: the longest watchdog that a host may request */
    uint32_t sequence;         /* number of the last state sent */
    uint32_t force_sequence;   /* number of the last force received */
    uint32_t watchdog;         /* us */
    uint64_t force_time;       /* us, when this force was received */
    float force[3];            /* N */
    float torque[3];           /* N m */
    /* N m; a larger torque is scaled down to this value; 0, no torque, after palpate_hid_start */
    float maximum_torque;
    bool alive;       /* whether forces arrive; set by a force, cleared by the watchdog */
    bool enabled;     /* whether the host requests the amplifiers to be on */
    uint32_t refused; /* number of reports that were invalid or old */
    uint32_t expired; /* number of times that the watchdog ended the force */
  } palpate_hid;

  /* Resets all members. The force is then zero. */
  void palpate_hid_start(palpate_hid* hid, float maximum_force, uint32_t longest_watchdog_us);

  /* Must be called with each report from the host. Returns true if the report was a new force. */
  bool palpate_hid_receive(palpate_hid* hid, const uint8_t* report, size_t size, uint64_t now_us);

  /* Sets `force` to the force to apply now, N. Sets zeros and returns false if the amplifiers are
   * off. They are off if no force has arrived yet, if the watchdog has expired, or if the host has
   * not enabled them. */
  bool palpate_hid_force(palpate_hid* hid, uint64_t now_us, float force[3]);

  /* Sets `torque` to the torque that belongs to the force, N m, about the tip. The torque is
   * limited to hid->maximum_torque, which must be set after palpate_hid_start. Sets zeros and
   * returns false under the same conditions as palpate_hid_force. */
  bool palpate_hid_torque(palpate_hid* hid, uint64_t now_us, float torque[3]);

  /* Writes the next state report to `report`. */
  void palpate_hid_state(palpate_hid* hid, uint64_t now_us, const palpate_hid_reading* reading,
    uint8_t report[PALPATE_HID_REPORT_SIZE]);

  /* Writes the description report to `report`. With the nonce 0 it is the feature report; with
   * another nonce it is the answer to a hello. */
  void palpate_hid_describe(const palpate_hid_description* description, uint32_t nonce,
    uint8_t report[PALPATE_HID_REPORT_SIZE]);

  /* For datagrams. Returns true if the report is a hello, and sets `nonce` to its nonce. */
  bool palpate_hid_hello(const uint8_t* report, size_t size, uint32_t* nonce);

  /* CRC-32 of IEEE 802.3, computed bit by bit. The result for "123456789" is 0xCBF43926. */
  uint32_t palpate_hid_check_sum(const uint8_t* bytes, size_t size);

#ifdef __cplusplus
}
#endif

#endif
