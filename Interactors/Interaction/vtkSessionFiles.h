// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSessionFiles
 * @brief writes pictures of the window and records of the session, under automatic names
 *
 * Files are "palpate-1.png", "palpate-1.csv" in OutputFolder, with the first free number, unless
 * they are given a name. A record contains every tick between two times of a session, as a
 * trajectory file for the device "replay:FILE"; it continues over a stop and a start. GetNotice
 * says, in words, what was last done. For the session's thread.
 */
#ifndef vtkSessionFiles_h
#define vtkSessionFiles_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::shared_ptr
#include <string> // For std::string

class vtkHapticSession;
class vtkRenderWindow;

namespace palpate
{
class TickTape;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkSessionFiles : public vtkObject
{
public:
  static vtkSessionFiles* New();
  vtkTypeMacro(vtkSessionFiles, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The session that is recorded. */
  void SetSession(vtkHapticSession* session);
  /** The window of the pictures. */
  void SetWindow(vtkRenderWindow* window);

  ///@{
  /** Folder of files without a name, created when needed. Default: the current folder. */
  vtkSetMacro(OutputFolder, std::string);
  vtkGetMacro(OutputFolder, std::string);
  ///@}
  ///@{
  /** What was last done, "picture palpate-1.png", for display. */
  vtkSetMacro(Notice, std::string);
  vtkGetMacro(Notice, std::string);
  ///@}

  /**
   * Writes the window as a .png; "": under an automatic name. Returns the name of the file, ""
   * after an error.
   */
  std::string WritePicture(const std::string& fileName = std::string());

  ///@{
  /**
   * Keeps every tick from StartRecording on, then writes them; "": under an automatic name.
   * Starting returns false, after an error, unless the session's recorder had HistorySeconds of
   * some frames at its Start, of which 1 is ample; writing returns the name of the file, "" after
   * an error. ToggleRecording starts or writes.
   */
  bool StartRecording();
  std::string WriteRecording(const std::string& fileName = std::string());
  void ToggleRecording();
  bool IsRecording() const;
  ///@}
  /** Ticks kept since StartRecording. */
  vtkIdType GetNumberOfRecordedTicks() const;

protected:
  vtkSessionFiles();
  ~vtkSessionFiles() override;

private:
  vtkSessionFiles(const vtkSessionFiles&) = delete;
  void operator=(const vtkSessionFiles&) = delete;

  std::string FreeName(const char* ending);
  std::string Finish(const std::string& what, const std::string& name, const std::string& error);

  vtkSmartPointer<vtkHapticSession> Session;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::shared_ptr<palpate::TickTape> Tape; ///< of the session's recorder; null before a recording
  std::string OutputFolder;
  std::string Notice;
};

#endif
