// SPDX-License-Identifier: BSD-3-Clause
#ifndef StyleKeys_h
#define StyleKeys_h

namespace palpate
{
/// What mouse and keys do in vtkInteractorStyleHaptic, as KeyHelp shows it.
inline constexpr const char* StyleKeys = "? or h\tthis help, on and off\n"
                                         "\n"
                                         "mouse on the body\tthe tool hovers under the pointer\n"
                                         "left button\tpress and slide\n"
                                         "wheel\tpress deeper, or less deep\n"
                                         "left beside the body\torbit\n"
                                         "middle, right\tpan, zoom\n"
                                         "Ctrl + wheel\tzoom\n"
                                         "\n"
                                         "Shift + wheel\tthe tool leans to the right, or left\n"
                                         "[ ]  { }\tleans left, right; towards you, away\n"
                                         "0\tit stands upright\n"
                                         "\n"
                                         "1 to 9\tchoose the tool\n"
                                         "n\tmove the next of several hands\n"
                                         "v\tthe pointer moves the tool in the plane of the view\n"
                                         "+  -\tdraw the dent deeper, less deep than it is\n"
                                         "c\tcompare the tools\n"
                                         "g  t\tcharts; how the servo thread keeps time\n"
                                         "x\tstop and start the session\n"
                                         "k\tkeep a record; write it\n"
                                         "p\twrite a picture of the window\n"
                                         "r\tthe whole body in view\n"
                                         "q\tquit";
} // namespace palpate

#endif
