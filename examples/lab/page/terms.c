/* terms.c - what the figures of a page mean. Declared in terms.h. */
#include "lab/page/terms.h"

void terms_chart(FILE *f)
{
    fputs("<h2>What the figures mean</h2>\n<dl>\n"
          "<dt>fetches<dd>Texel fetches per pixel, summed over all passes of the method.\n"
          "<dt>bytes<dd>What a frame moves per pixel at the least: each pass reads each texel of its inputs once and "
          "writes each texel of its outputs once, in the formats in which they are stored; "
          "of splats, which are blended, each texel that they cover is read and written, and surfels are read once.\n"
          "<dt>time<dd>GL time of all passes, over that of one unblurred 16-sample SSAO drawn right before and after "
          "it in the same run; the median of several rounds. Below 1 is cheaper than that SSAO.\n"
          "<dt>RMSE, share<dd>Root mean square difference to the ray-traced truth, over the pixels that show "
          "something, of ambient visibility (0 closed, 1 open), as it comes, with no fit or gain. "
          "The share is RMSE over the RMSE of having no AO at all, so 1 means that the pass might as well be left "
          "out.\n"
          "<dt>bias, p95, SSIM<dd>The mean difference (below 0: too dark), the difference that 95 % of the pixels stay "
          "under, the structural similarity.\n"
          "<dt>edge, border, inside<dd>Which shares of the squared error sit within 3 pixels of a jump in depth; "
          "elsewhere, nearer to the picture's border than the radius is long; and in the rest. With light: of "
          "irradiance. The CSV has their shares of the pixels, RMSE and bias as well.\n"
          "<dt>model, noise<dd>Drawn with two phases of its noise: the model's error is what their mean picture is "
          "off, the noise what a pixel varies by, as under light below. The noise is 0 where no phase changes the "
          "picture.\n"
          "<dt>margin<dd>The depth buffer is larger than the picture on each side, by so many radii as projected at "
          "the "
          "border; time is that of the passes: a larger depth buffer has to be drawn, too.\n"
          "<dt>grey band<dd>The Pareto front: no other point of the chart is both faster and closer to the truth.\n"
          "<dt>floor<dd>The exact answer from one depth layer, ray-traced against the visible surface taken as thin "
          "sheets. What lies between it and the truth is not in the depth buffer: "
          "more layers or cameras buy it. A method above the floor can win by more samples; one below it does so by "
          "assuming how thick things are.\n</dl>\n",
          f);
}

void terms_light(FILE *f)
{
    fputs("<dl>\n<dt>radiance, irradiance, bounce<dd>Root mean square difference to the ray-traced truth, over the "
          "truth's mean, red, green and blue together, over the pixels that show something: of the light that "
          "leaves the surface; of the light that arrives, over pi, from the environment and from lights with their "
          "shadows; and of light that was reflected once before. The bias after each is the mean difference, over "
          "the same mean. No gain, no fit.\n"
          "<dt>time, of light<dd>As above: all passes of a frame, among them the lights' shadows and the light of "
          "hidden emitters. Not in it: drawing the G-buffer, its farther layers, extra cameras' G-buffers and shadow "
          "maps.\n"
          "<dt>truth, of light<dd>The environment and the bounce are weighted by 1 &minus; t/radius of the nearest "
          "hit, as the methods take them; lights are shadowed by the whole scene, "
          "unless it says that suns are local: then they are small discs, blocked like the environment.\n"
          "<dt>bias error, noise, hue<dd>Each method drawn with eight phases of its noise. The bias error is what "
          "their mean picture is off, the noise what a pixel varies by (the mean over the pixels of its variance; what "
          "is left of "
          "it in the mean picture is taken off the bias error): the squares of both add up to that of the irradiance's "
          "error. All over the truth's mean. Hue: the angle between the red, green and blue of the mean picture's "
          "irradiance and the truth's, "
          "its mean over the pixels weighted by the truth's luminance; and over those that occluders keep 5 % or more "
          "of their light from.\n</dl>\n",
          f);
}

void terms_fields(FILE *f)
{
    fputs("<dl>\n<dt>occlusion between objects<dd>What rigid occluders take from the ambient light of other things, at "
          "any distance; occluders do not shade themselves. Its truth: rays that are blocked by all occluders but the "
          "one "
          "that the pixel shows, at any distance; the fields end at eight radii of an occluder's bounding sphere. "
          "Errors are of occlusion, over the pixels that show something else than the only occluder.\n</dl>\n",
          f);
}

void terms_deep(FILE *f)
{
    fputs("<dl>\n<dt>surfels, splats<dd>Deep screen space makes discs of all triangles, seen or not, of a size in "
          "picture heights, and draws each over the pixels that it reaches. Splats: the texels so drawn, all levels, "
          "over the "
          "picture's pixels; a graphics card and a software rasteriser spend nearly all of the time there.\n"
          "<dt>truth, of deep screen space<dd>Ambient visibility: as above, weighted by 1 &minus; t/radius. Light of "
          "surfels has no such weight: what is within the radius counts whole, in the truth of its rows, too, while "
          "ssdo's rows keep their own. "
          "One specular bounce: rays by the lobe, their hits lit and shadowed. Scattering: the dipole's sum over "
          "samples on all of the mesh, shadowed by rays.\n"
          "<dt>varies<dd>A place's ambient visibility in a few frames of a camera that moves, between four pixels "
          "around it; places that any frame does not show are left out.\n</dl>\n",
          f);
}

void terms_peers(FILE *f)
{
    fputs("<dl>\n<dt>three.js, n8ao, Babylon.js, PlayCanvas<dd>Other people's ambient occlusion, as their own code "
          "draws it, denoisers included, on the same depth and normals, timed in the same rounds; what only multiplies "
          "the picture by it is not timed. Defaults: as they come, whatever the scene's units. Else with the radius R "
          "of ours, and with what of theirs shapes the effect chosen for the least error in these scenes.\n"
          "<dt>fitted<dd>The share after the better of a v<sup>b</sup> and 1 &minus; a (1 &minus; v)<sup>b</sup>, "
          "clamped, with the best a and b for that one picture, found with the truth in hand: no gain or power of "
          "theirs comes nearer.\n</dl>\n",
          f);
}
