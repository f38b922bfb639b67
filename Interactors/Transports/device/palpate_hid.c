/* SPDX-License-Identifier: BSD-3-Clause */
#include "palpate_hid.h"

#include <math.h>
#include <string.h>

enum
{
  mark = 0x50,
  version = 1,
  kind_state = 1,
  kind_force = 2,
  kind_description = 3,
  kind_hello = 4,
  check_sum_offset = 60
};

/* clang-format off */
const uint8_t palpate_hid_report_descriptor[PALPATE_HID_DESCRIPTOR_SIZE] = {
  0x06, 0x00, 0xFF,             /* Usage Page (vendor, 0xFF00) */
  0x09, 0x50,                   /* Usage (0x50) */
  0xA1, 0x01,                   /* Collection (Application) */
  0x15, 0x00, 0x26, 0xFF, 0x00, /*   Logical Minimum 0, Maximum 255 */
  0x75, 0x08,                   /*   Report Size 8 bits */
  0x95, 0x40,                   /*   Report Count 64 */
  0x09, 0x51, 0x81, 0x02,       /*   Usage 0x51: Input (Data, Variable, Absolute): state */
  0x09, 0x52, 0x91, 0x02,       /*   Usage 0x52: Output: force */
  0x09, 0x53, 0xB1, 0x02,       /*   Usage 0x53: Feature: description */
  0xC0                          /* End Collection */
};
/* clang-format on */

uint32_t palpate_hid_check_sum(const uint8_t* bytes, size_t size)
{
  uint32_t remainder = 0xFFFFFFFFu;
  for (size_t i = 0; i < size; ++i)
  {
    remainder ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit)
    {
      remainder = (remainder >> 1) ^ ((remainder & 1u) ? 0xEDB88320u : 0u);
    }
  }
  return ~remainder;
}

/* Fields are little-endian, regardless of the byte order of the processor. */
static void put32(uint8_t* to, uint32_t value)
{
  for (int i = 0; i < 4; ++i)
  {
    to[i] = (uint8_t)(value >> (8 * i));
  }
}

static uint32_t get32(const uint8_t* from)
{
  return (uint32_t)from[0] | (uint32_t)from[1] << 8 | (uint32_t)from[2] << 16 |
    (uint32_t)from[3] << 24;
}

static void put64(uint8_t* to, uint64_t value)
{
  put32(to, (uint32_t)value);
  put32(to + 4, (uint32_t)(value >> 32));
}

static void put_float(uint8_t* to, float value)
{
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  put32(to, bits);
}

static float get_float(const uint8_t* from)
{
  const uint32_t bits = get32(from);
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/* Whether a float is neither NaN nor infinite. The test also works if the compiler assumes finite
 * numbers. */
static bool is_finite(const uint8_t* from)
{
  return (get32(from) & 0x7F800000u) != 0x7F800000u;
}

static bool are_finite(const uint8_t* from)
{
  return is_finite(from) && is_finite(from + 4) && is_finite(from + 8);
}

static void begin(uint8_t* report, uint8_t kind, bool first_flag, bool second_flag)
{
  memset(report, 0, PALPATE_HID_REPORT_SIZE);
  report[0] = mark;
  report[1] = kind;
  report[2] = version;
  report[3] = (uint8_t)((first_flag ? 1 : 0) | (second_flag ? 2 : 0));
}

static void finish(uint8_t* report)
{
  put32(report + check_sum_offset, palpate_hid_check_sum(report, check_sum_offset));
}

static bool is_report(const uint8_t* report, size_t size, uint8_t kind)
{
  return size == PALPATE_HID_REPORT_SIZE && report[0] == mark && report[1] == kind &&
    report[2] == version &&
    get32(report + check_sum_offset) == palpate_hid_check_sum(report, check_sum_offset);
}

void palpate_hid_start(palpate_hid* hid, float maximum_force, uint32_t longest_watchdog_us)
{
  memset(hid, 0, sizeof *hid);
  hid->maximum_force = maximum_force;
  hid->longest_watchdog = longest_watchdog_us;
}

/* Ends the last force when its time has expired. The force is then zero until the next report. */
static void watch(palpate_hid* hid, uint64_t now_us)
{
  if (hid->alive && now_us - hid->force_time > hid->watchdog)
  {
    hid->alive = false;
    ++hid->expired;
  }
}

bool palpate_hid_receive(palpate_hid* hid, const uint8_t* report, size_t size, uint64_t now_us)
{
  uint32_t number;
  watch(hid, now_us);
  if (!is_report(report, size, kind_force) || !are_finite(report + 16) || !are_finite(report + 36))
  {
    ++hid->refused;
    return false;
  }
  number = get32(report + 4);
  /* Numbers are compared modulo 2^32; old and repeated numbers are refused. After the watchdog has
   * expired, any number is accepted, because the host may have restarted. */
  if (hid->alive && (number == hid->force_sequence || number - hid->force_sequence > 0x7FFFFFFFu))
  {
    ++hid->refused;
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    hid->force[i] = get_float(report + 16 + 4 * i);
    hid->torque[i] = get_float(report + 36 + 4 * i);
  }
  hid->enabled = (report[3] & 1) != 0;
  hid->force_sequence = number;
  hid->watchdog = get32(report + 28);
  if (hid->watchdog > hid->longest_watchdog)
  {
    hid->watchdog = hid->longest_watchdog;
  }
  hid->force_time = now_us;
  hid->alive = true;
  return true;
}

/* Copies a vector from the host, limited to the length `most`. While the amplifiers are off, sets
 * the vector to zero and returns false. */
static bool applied(palpate_hid* hid, uint64_t now_us, const float from[3], float most, float to[3])
{
  float length;
  float share = 1.0f;
  watch(hid, now_us);
  to[0] = to[1] = to[2] = 0.0f;
  if (!hid->alive || !hid->enabled)
  {
    return false;
  }
  length = sqrtf(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]);
  if (length > most)
  {
    share = most / length; /* 0 if the square has overflowed */
  }
  for (int i = 0; i < 3; ++i)
  {
    to[i] = share * from[i];
  }
  return true;
}

bool palpate_hid_force(palpate_hid* hid, uint64_t now_us, float force[3])
{
  return applied(hid, now_us, hid->force, hid->maximum_force, force);
}

bool palpate_hid_torque(palpate_hid* hid, uint64_t now_us, float torque[3])
{
  return applied(hid, now_us, hid->torque, hid->maximum_torque, torque);
}

/* Omits the largest of the four components and makes it positive. The host computes the omitted
 * component, because the sum of the squares is 1. */
static void put_orientation(uint8_t* report, const float quaternion[4])
{
  int largest = 0;
  uint8_t* to = report + 48;
  for (int i = 1; i < 4; ++i)
  {
    if (quaternion[i] * quaternion[i] > quaternion[largest] * quaternion[largest])
    {
      largest = i;
    }
  }
  if (quaternion[largest] == 0.0f)
  {
    return; /* unknown */
  }
  report[3] = (uint8_t)(report[3] | 4 | largest << 3);
  for (int i = 0; i < 4; ++i)
  {
    if (i != largest)
    {
      put_float(to, quaternion[largest] < 0.0f ? -quaternion[i] : quaternion[i]);
      to += 4;
    }
  }
}

void palpate_hid_state(palpate_hid* hid, uint64_t now_us, const palpate_hid_reading* reading,
  uint8_t report[PALPATE_HID_REPORT_SIZE])
{
  watch(hid, now_us);
  begin(report, kind_state, hid->alive && hid->enabled, reading->fault);
  put32(report + 4, ++hid->sequence);
  put64(report + 8, now_us);
  for (int i = 0; i < 3; ++i)
  {
    put_float(report + 16 + 4 * i, reading->position[i]);
    put_float(report + 28 + 4 * i, reading->velocity[i]);
  }
  put32(report + 40, reading->buttons);
  put32(report + 44, hid->force_sequence);
  put_orientation(report, reading->orientation);
  finish(report);
}

void palpate_hid_describe(const palpate_hid_description* description, uint32_t nonce,
  uint8_t report[PALPATE_HID_REPORT_SIZE])
{
  begin(report, kind_description, description->outputs_force, description->planar);
  put_float(report + 4, description->maximum_force);
  put_float(report + 8, description->maximum_stiffness);
  put_float(report + 12, description->maximum_force_rate);
  put_float(report + 16, description->maximum_damping);
  for (int i = 0; i < 3; ++i)
  {
    put_float(report + 20 + 4 * i, description->half_extents[i]);
  }
  put_float(report + 32, description->rate);
  put_float(report + 36, description->sample_time_out);
  memcpy(report + 40, description->name, sizeof description->name);
  put32(report + 56, nonce);
  if (description->outputs_torque)
  {
    report[3] |= 4;
    report[43] = 0; /* end of a name of 3 bytes */
    put_float(report + 44, description->maximum_torque);
    put_float(report + 48, description->maximum_torsional_stiffness);
    put_float(report + 52, description->maximum_torque_rate);
  }
  finish(report);
}

bool palpate_hid_hello(const uint8_t* report, size_t size, uint32_t* nonce)
{
  if (!is_report(report, size, kind_hello))
  {
    return false;
  }
  *nonce = get32(report + 4);
  return true;
}
