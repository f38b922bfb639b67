// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SingleThread_h
#define palpate_SingleThread_h

#include <mutex>

extern "C"
{
  // OpenBLAS's, if that is the BLAS; otherwise null.
  __attribute__((weak)) int openblas_get_num_threads();
  __attribute__((weak)) void openblas_set_num_threads(int count);

  // OpenMP's, if anything has loaded it, as CHOLMOD may have.
  __attribute__((weak)) int omp_get_max_active_levels();
  __attribute__((weak)) void omp_set_max_active_levels(int count);
}

namespace palpate
{
/// While one lives, OpenBLAS uses only the calling thread: several would sum in another order, and
/// the blocks are already distributed to threads. The setting is that of the whole process; the
/// last object restores it.
class SingleThreadedBlas
{
public:
  SingleThreadedBlas()
  {
    const std::lock_guard<std::mutex> lock(Guard);
    if (isThere() && Living++ == 0)
    {
      Before = openblas_get_num_threads();
      openblas_set_num_threads(1);
    }
  }
  ~SingleThreadedBlas()
  {
    const std::lock_guard<std::mutex> lock(Guard);
    if (isThere() && --Living == 0)
    {
      openblas_set_num_threads(Before);
    }
  }
  SingleThreadedBlas(const SingleThreadedBlas&) = delete;
  SingleThreadedBlas& operator=(const SingleThreadedBlas&) = delete;

private:
  static bool isThere()
  {
    return openblas_get_num_threads != nullptr && openblas_set_num_threads != nullptr;
  }

  inline static std::mutex Guard;
  inline static int Living = 0;
  inline static int Before = 0;
};

/// While one lives, CHOLMOD starts no threads of its own from this one: four for each of its loops,
/// which spin while they wait for the next, a third of the time of two cores that are busy already.
class WithoutOpenMp
{
public:
  WithoutOpenMp()
  {
    if (isThere())
    {
      this->Was = omp_get_max_active_levels();
      omp_set_max_active_levels(0);
    }
  }
  ~WithoutOpenMp()
  {
    if (isThere())
    {
      omp_set_max_active_levels(this->Was > 0 ? this->Was : AtFirst);
    }
  }
  WithoutOpenMp(const WithoutOpenMp&) = delete;
  WithoutOpenMp& operator=(const WithoutOpenMp&) = delete;

private:
  static bool isThere()
  {
    return omp_get_max_active_levels != nullptr && omp_set_max_active_levels != nullptr;
  }

  int Was = 0;
  // It may be one number for all threads, and 0 since another of these lives.
  inline static const int AtFirst = isThere() ? omp_get_max_active_levels() : 0;
};

/// While one lives, BLAS and CHOLMOD use only the calling thread: work is distributed already.
class SingleThread
{
  SingleThreadedBlas Blas;
  WithoutOpenMp OpenMp;
};
} // namespace palpate

#endif
