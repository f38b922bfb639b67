// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SingleThread_h
#define palpate_SingleThread_h

#include <mutex>

extern "C"
{
  // Functions of OpenBLAS. They are null if another BLAS is used.
  __attribute__((weak)) int openblas_get_num_threads();
  __attribute__((weak)) void openblas_set_num_threads(int count);

  // Functions of OpenMP. They are null unless OpenMP is loaded, for example by CHOLMOD.
  __attribute__((weak)) int omp_get_max_active_levels();
  __attribute__((weak)) void omp_set_max_active_levels(int count);
}

namespace palpate
{
/// While an object of this class exists, OpenBLAS uses only the calling thread. Several threads
/// would sum in another order. They are not needed, because the blocks are already distributed to
/// threads. The setting applies to the whole process. The last object restores it.
class SingleThreadedBlas
{
public:
  SingleThreadedBlas()
  {
    const std::lock_guard<std::mutex> lock(Guard);
    if (isThere() && Living++ == 0)
    {
      ThreadsBefore = openblas_get_num_threads();
      openblas_set_num_threads(1);
    }
  }
  ~SingleThreadedBlas()
  {
    const std::lock_guard<std::mutex> lock(Guard);
    if (isThere() && --Living == 0)
    {
      openblas_set_num_threads(ThreadsBefore);
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
  inline static int ThreadsBefore = 0;
};

/// While an object of this class exists, CHOLMOD starts no threads of its own from this thread.
/// Otherwise CHOLMOD starts four threads for each of its loops. These threads spin while they wait
/// for the next loop, which takes a third of the time of two cores that are already busy.
class WithoutOpenMp
{
public:
  WithoutOpenMp()
  {
    if (isThere())
    {
      this->LevelsBefore = omp_get_max_active_levels();
      omp_set_max_active_levels(0);
    }
  }
  ~WithoutOpenMp()
  {
    if (isThere())
    {
      omp_set_max_active_levels(this->LevelsBefore > 0 ? this->LevelsBefore : LevelsAtStart);
    }
  }
  WithoutOpenMp(const WithoutOpenMp&) = delete;
  WithoutOpenMp& operator=(const WithoutOpenMp&) = delete;

private:
  static bool isThere()
  {
    return omp_get_max_active_levels != nullptr && omp_set_max_active_levels != nullptr;
  }

  int LevelsBefore = 0;
  // The OpenMP runtime may keep one setting for all threads. `LevelsBefore` is then 0 if another
  // object already exists.
  inline static const int LevelsAtStart = isThere() ? omp_get_max_active_levels() : 0;
};

/// While an object of this class exists, BLAS and CHOLMOD use only the calling thread, because the
/// work is already distributed to threads.
class SingleThread
{
  SingleThreadedBlas Blas;
  WithoutOpenMp OpenMp;
};
} // namespace palpate

#endif
