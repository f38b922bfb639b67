/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Template of a program that makes any vendor's device available to Palpate. Call the vendor's SDK
 * in the two functions at the top.
 *   cc bridge_device.c palpate_hid.c -lm -o bridge_device && ./bridge_device /tmp/d
 * Then the address of the device is bridge:unix:/tmp/d.
 */
#define _POSIX_C_SOURCE 200809L
#include "palpate_hid.h"

#include <math.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

static void sdk_read(palpate_hid_reading* hand, double seconds) /* here: a hand that taps */
{
  hand->position[2] = 0.01f * (float)cos(6.2831853 * seconds);
  hand->orientation[0] = 1.0f; /* upright; zeros if the SDK does not report it */
}
static void sdk_write(const float force[3], const float torque[3])
{
  (void)force;  /* N */
  (void)torque; /* N m: zeros here, since `me` outputs none */
}

int main(int argc, char** argv)
{
  const palpate_hid_description me = { true, false, 3.0f, 1000.0f, 1000.0f, 5.0f,
    { 0.1f, 0.1f, 0.1f }, 1000.0f, 0.02f, "My device", false, 0.0f, 0.0f, 0.0f };
  const int file = socket(AF_UNIX, SOCK_DGRAM, 0);
  struct sockaddr_un own = { .sun_family = AF_UNIX }, host = { 0 };
  socklen_t host_size = 0;
  struct timespec now;
  palpate_hid hid;
  strncpy(own.sun_path, argc > 1 ? argv[1] : "", sizeof own.sun_path - 1);
  unlink(own.sun_path);
  if (bind(file, (struct sockaddr*)&own, sizeof own) != 0)
    return 1;
  palpate_hid_start(&hid, me.maximum_force, 20000);
  hid.maximum_torque = me.maximum_torque;
  for (clock_gettime(CLOCK_MONOTONIC, &now);; now.tv_nsec += 1000000)
  {
    uint8_t report[PALPATE_HID_REPORT_SIZE + 1];
    palpate_hid_reading hand = { { 0 }, { 0 }, 0, false, { 0 } };
    float force[3], torque[3];
    if (now.tv_nsec >= 1000000000)
      now.tv_nsec -= 1000000000, ++now.tv_sec;
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &now, NULL); /* or wait for the SDK's tick */
    const uint64_t us = (uint64_t)now.tv_sec * 1000000 + (uint64_t)now.tv_nsec / 1000;
    for (;;)
    { /* all that has arrived: the newest force is used, a hello is answered */
      struct sockaddr_un from = { 0 };
      socklen_t size = sizeof from;
      uint32_t nonce;
      const ssize_t n =
        recvfrom(file, report, sizeof report, MSG_DONTWAIT, (struct sockaddr*)&from, &size);
      if (n < 0)
        break;
      if (palpate_hid_hello(report, (size_t)n, &nonce))
      {
        host = from, host_size = size;
        palpate_hid_describe(&me, nonce, report);
        sendto(file, report, 64, MSG_DONTWAIT, (struct sockaddr*)&host, host_size);
      }
      else if (memcmp(&from, &host, sizeof host) == 0)
        palpate_hid_receive(&hid, report, (size_t)n, us);
    }
    palpate_hid_force(&hid, us, force);
    palpate_hid_torque(&hid, us, torque);
    sdk_write(force, torque);
    sdk_read(&hand, 1e-6 * (double)us);
    palpate_hid_state(&hid, us, &hand, report);
    sendto(file, report, 64, MSG_DONTWAIT, (struct sockaddr*)&host, host_size);
  }
}
