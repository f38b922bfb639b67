// SPDX-License-Identifier: BSD-3-Clause
// An off-screen window, its picture, and the difference of two pictures.
#ifndef palpate_testing_Picture_h
#define palpate_testing_Picture_h

#include "Response/FilterChecks.h"

#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTesting.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>

namespace palpate::testing
{
/**
 * Difference in grey levels, summed over red, green and blue, that is ignored between a pixel and
 * the pixels around it in the other picture. vtkTesting ignores 105, which would hide differences
 * of translucent parts, such as a tool in another direction.
 */
constexpr int ForgivenLevels = 10;

/**
 * The largest allowed difference from a baseline: the sum over all pixels, in units of a fully
 * white pixel.
 *
 * The same code gives the same pixels in every run and for any number of threads. With this
 * measure, another rasteriser (Mesa's softpipe) makes no difference either, except for the bar of
 * the legend, which it does not draw. The smallest fault that the tests add to their scenes gives a
 * difference of 17; checkFaultShows requires 10.
 */
constexpr double PictureThreshold = 5.0;

/// An off-screen window of fixed size without multisampling, so that the pixels are the same in
/// every run.
struct Picture
{
  vtkNew<vtkRenderWindow> window;

  Picture(int width, int height)
  {
    this->window->SetOffScreenRendering(1);
    this->window->SetMultiSamples(0);
    this->window->SetSize(width, height);
  }

  vtkSmartPointer<vtkRenderer> addRenderer(double left = 0.0, double right = 1.0)
  {
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetViewport(left, 0.0, right, 1.0);
    this->window->AddRenderer(renderer);
    return renderer;
  }
};

inline vtkSmartPointer<vtkImageData> draw(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}

inline void writePicture(vtkImageData* picture, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(file.c_str());
  writer->Write();
}

/// Returns the difference of two pictures, in units of PictureThreshold. Writes the difference
/// image to `file`, unless `file` is empty.
inline double difference(vtkImageData* one, vtkImageData* other, const std::string& file = "")
{
  if (!std::equal(one->GetDimensions(), one->GetDimensions() + 3, other->GetDimensions()))
  {
    return std::numeric_limits<double>::infinity();
  }
  vtkNew<vtkImageDifference> compare;
  compare->SetThreshold(ForgivenLevels);
  compare->SetInputData(one);
  compare->SetImageData(other);
  compare->Update();
  if (!file.empty())
  {
    writePicture(compare->GetOutput(), file);
  }
  return compare->GetThresholdedError();
}

/// Compares with the baseline that the command line names (-V FILE). Writes the picture into the
/// folder of -T FOLDER under the name of the baseline, so that it can be examined and copied. If
/// the pictures differ, also writes the difference image.
inline void checkBaseline(vtkRenderWindow* window, int argc, char* argv[])
{
  vtkNew<vtkTesting> arguments;
  arguments->AddArguments(argc, argv);
  const std::filesystem::path baseline = arguments->GetValidImageFileName();
  const std::filesystem::path folder = arguments->GetTempDirectory();
  const auto picture = draw(window);
  writePicture(picture, (folder / baseline.filename()).string());
  const bool exists = std::filesystem::exists(baseline);
  double found = std::numeric_limits<double>::infinity();
  // X_1.png next to X.png is the same picture, drawn by another version of VTK.
  for (const char* variant : { "", "_1" })
  {
    const std::string stem = baseline.stem().string() + variant;
    const std::filesystem::path file = baseline.parent_path() / (stem + ".png");
    if (std::filesystem::exists(file))
    {
      vtkNew<vtkPNGReader> reader;
      reader->SetFileName(file.c_str());
      reader->Update();
      const std::string name = (folder / (stem + ".difference.png")).string();
      found = std::min(found, difference(reader->GetOutput(), picture, name));
    }
  }
  std::cout << baseline.filename().string() << ": image difference " << found << ", at most "
            << PictureThreshold << " passes; picture in " << folder << std::endl;
  PALPATE_CHECK(exists); // see Testing/Baseline/README.md
  PALPATE_CHECK(found <= PictureThreshold);
}

/// Checks that a scene with a fault differs from the correct scene by twice the threshold. Prints
/// the difference.
inline void checkFaultShows(const std::string& fault, vtkImageData* sound, vtkRenderWindow* window)
{
  const double found = difference(sound, draw(window));
  std::cout << "fault: " << fault << ": image difference " << found << std::endl;
  PALPATE_CHECK(found > 2.0 * PictureThreshold);
}

/// Checks that a scene is correct again after a fault has been undone.
inline void checkSound(vtkImageData* sound, vtkRenderWindow* window)
{
  PALPATE_CHECK(difference(sound, draw(window)) == 0.0);
}
} // namespace palpate::testing

#endif
