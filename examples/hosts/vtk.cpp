/* vtk.cpp - ambient occlusion in VTK 9 by the pass of vtkSSGIPass.h. All surfaces are white and all light is ambient,
   so the picture is the occlusion. Debian: libvtk9-dev; its version is part of these names.
     c++ -std=c++17 examples/hosts/vtk.cpp -I/usr/include/vtk-9.1 -lvtkRenderingOpenGL2-9.1 -lvtkRenderingCore-9.1 \
     -lvtkIOGeometry-9.1 -lvtkIOImage-9.1 -lvtkFiltersSources-9.1 -lvtkCommonExecutionModel-9.1 \
     -lvtkCommonDataModel-9.1 -lvtkCommonMath-9.1 -lvtkCommonCore-9.1 -lvtksys-9.1 -lGL -o vtk && \
     ./vtk MESH.obj ex,ey,ez,tx,ty,tz RADIUS OUT      writes OUT.png, OUT-pane.png */
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "vtkSSGIPass.h"
#include <vtkActor.h>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkOBJReader.h>
#include <vtkOpaquePass.h>
#include <vtkPNGWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkWindowToImageFilter.h>
#include <cstdio>
VTK_MODULE_INIT(vtkRenderingOpenGL2);

static void save(vtkRenderWindow *window, const std::string &path)
{
    vtkNew<vtkWindowToImageFilter> picture;
    vtkNew<vtkPNGWriter> file;
    picture->SetInput(window);
    picture->ReadFrontBufferOff();
    file->SetInputConnection(picture->GetOutputPort());
    file->SetFileName(path.c_str());
    file->Write();
}

int main(int argc, char **argv)
{
    double p[6];
    if (argc != 5 || std::sscanf(argv[2], "%lf,%lf,%lf,%lf,%lf,%lf", p, p + 1, p + 2, p + 3, p + 4, p + 5) != 6)
        return std::puts("usage: vtk MESH.obj ex,ey,ez,tx,ty,tz RADIUS OUT"), 2;
    const double radius = std::strtod(argv[3], nullptr);
    const std::string out = argv[4];
    vtkNew<vtkOBJReader> mesh;
    vtkNew<vtkPolyDataMapper> mapper, flat;
    vtkNew<vtkActor> actor, pane;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkRenderWindow> window;
    mesh->SetFileName(argv[1]);
    mapper->SetInputConnection(mesh->GetOutputPort());
    actor->SetMapper(mapper);
    for (vtkActor *one : { actor.Get(), pane.Get() }) {
        one->GetProperty()->SetAmbient(1);
        one->GetProperty()->SetDiffuse(0);
    }
    renderer->AddActor(actor);
    renderer->SetBackground(1, 1, 1);
    window->AddRenderer(renderer);
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    vtkCamera *camera = renderer->GetActiveCamera();
    camera->SetPosition(p), camera->SetFocalPoint(p + 3), camera->SetViewUp(0, 1, 0), camera->SetViewAngle(45);
    renderer->ResetCameraClippingRange();

    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSGIPass> ssgi;
    ssgi->SetDelegatePass(steps);
    ssgi->SetRadius(radius);
    renderer->SetPass(ssgi);
    /* draws first at another size, so that the pass makes its textures twice */
    window->SetSize(800, 450);
    window->Render();
    window->SetSize(960, 540);
    window->Render();
    save(window, out + ".png");

    /* adds a translucent pane in front of everything, drawn after occlusion: half green over the image */
    vtkNew<vtkPlaneSource> plane;
    vtkNew<vtkOpaquePass> opaque;
    plane->SetOrigin(-1.5, 0.5, 3), plane->SetPoint1(1.5, 0.5, 3), plane->SetPoint2(-1.5, 3.5, 3);
    flat->SetInputConnection(plane->GetOutputPort());
    pane->SetMapper(flat);
    pane->GetProperty()->SetColor(0, 1, 0), pane->GetProperty()->SetOpacity(0.5);
    renderer->AddActor(pane);
    ssgi->SetDelegatePass(opaque);
    steps->SetOpaquePass(ssgi);
    renderer->SetPass(steps);
    for (int i = 0; i < 2; ++i) window->Render();
    save(window, out + "-pane.png");
    return 0;
}
