// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTrajectoryReader
 * @brief reads a recorded trajectory (.csv) as a polyline of tips that grows with time
 *
 * Reads the record of a session (`palpate --record`, the offscreen session's trajectory.csv), or
 * any .csv with the columns time_s, tip_x_mm, tip_y_mm, tip_z_mm; see palpate::readTrajectory.
 *
 * Output: the tips in order, mm, body frame, as one polyline with the point arrays `Time` (double,
 * s) and, if the file has them, `ContactPoint` (3, mm), `Deflection` (mm), `NormalForce` (N) and
 * its part `MemoryForce` (N), `FrictionForce` (3, N), `IdealForce` (N, magnitude of the total),
 * `ContactState` (uint8, as in vtkToolContactProbe), `ToolAxis` (3, from tip to hand) and `Torque`
 * (3, N mm, about the tip). For the device, in its own frame: `DevicePosition` (3, m) and
 * `SentForce` (3, N). Ticks without a valid sample have no tip and are omitted. The field array
 * `RecordedSetup` has the lines of the file on body, tool, material, model and friction, such as
 * "tool: sphere:6.35".
 *
 * Time: the reader announces FrameRate time steps per second over the times of the file. The output
 * at a time t ends with the last tip whose time is at most t. This last tip is the present tip for
 * vtkToolContactProbe, vtkContactDeflection and vtkContactHistory. With WholePath, or if no time is
 * requested, the output is the whole path.
 *
 * The reader fails if there is no file, or if the file is not a trajectory. The error names file,
 * line and fault; the output is then empty. The file is read again only when its name or its
 * modification time has changed. Each request copies the tips up to the requested time.
 *
 * @code{.py}
 * trajectory = palpate.vtkTrajectoryReader()
 * trajectory.SetFileName("trajectory.csv")             # of palpate --record
 * trajectory.WholePathOn()
 * trajectory.Update()
 * probe.SetTipConnection(trajectory.GetOutputPort())   # the same path on another body
 * @endcode
 */
#ifndef vtkTrajectoryReader_h
#define vtkTrajectoryReader_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <filesystem> // For std::filesystem::file_time_type
#include <memory>     // For std::unique_ptr
#include <string>     // For std::string

namespace palpate
{
struct Trajectory;
}

class PALPATEINTERACTION_EXPORT vtkTrajectoryReader : public vtkPolyDataAlgorithm
{
public:
  static vtkTrajectoryReader* New();
  vtkTypeMacro(vtkTrajectoryReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The name of the file. Required. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Number of announced time steps per second, 1 to 10000. Default 25. A session has a thousand or
   * more ticks per second.
   */
  vtkSetClampMacro(FrameRate, double, 1.0, 10000.0);
  vtkGetMacro(FrameRate, double);
  ///@}

  ///@{
  /** Whether the output has all tips, regardless of the requested time. Default off. */
  vtkSetMacro(WholePath, bool);
  vtkGetMacro(WholePath, bool);
  vtkBooleanMacro(WholePath, bool);
  ///@}

  /** Returns 1 if the first line that is not a comment names the columns of a trajectory, else 0.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkTrajectoryReader();
  ~vtkTrajectoryReader() override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkTrajectoryReader(const vtkTrajectoryReader&) = delete;
  void operator=(const vtkTrajectoryReader&) = delete;

  /// Reads the file. Returns "" or an error message.
  std::string Read();

  char* FileName = nullptr;
  double FrameRate = 25.0;
  bool WholePath = false;

  std::unique_ptr<palpate::Trajectory> Known; ///< content of the last file; only ticks with a tip
  std::string KnownFile;
  std::filesystem::file_time_type KnownTime; ///< modification time of the file
};

#endif
