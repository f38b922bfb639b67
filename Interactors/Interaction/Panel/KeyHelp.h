// SPDX-License-Identifier: BSD-3-Clause
#ifndef KeyHelp_h
#define KeyHelp_h

#include "Interaction/Panel/PixelBox.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// A sheet of text in the middle of a renderer. It lists the functions of keys and mouse in two
/// columns.
class KeyHelp
{
public:
  KeyHelp();
  ~KeyHelp();
  KeyHelp(const KeyHelp&) = delete;
  KeyHelp& operator=(const KeyHelp&) = delete;

  /// Sets the text, one line per key: "key<tab>function". An empty line makes a gap.
  void setText(const std::string& text);
  const std::string& text() const { return this->Text; }

  /// Shows the sheet in a renderer, in front of all other props. If `renderer` is null, the sheet
  /// is hidden.
  void show(vtkRenderer* renderer);
  bool isShown() const { return this->Renderer != nullptr; }

private:
  /// Centres the sheet in the window at its present size.
  void place();

  std::string Text;
  vtkSmartPointer<vtkTextActor> Keys;
  vtkSmartPointer<vtkTextActor> Meanings;
  PixelBox Sheet;
  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
};
} // namespace palpate

#endif
