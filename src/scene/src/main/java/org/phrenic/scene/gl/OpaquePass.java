package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.SceneStyle;

/**
 * Draws the background and the opaque surfaces. What stands still (background, spine) is drawn once while camera and
 * style rest: its colour and depth are kept, and in later pictures copied, and what moves is drawn over them. Opaque
 * surfaces are told apart by depth alone, so the picture is the one in which all is drawn anew. The copy is made with
 * the second picture of a view, so that it costs nothing while the camera moves.
 */
final class OpaquePass {
    private final SurfacePass faces;
    private final ScreenPass screen;
    private final CapPass caps;
    private List<?> keptView = List.of();
    private RenderTargets keptIn;

    OpaquePass(SurfacePass faces, ScreenPass screen, CapPass caps) {
        this.faces = faces;
        this.screen = screen;
        this.caps = caps;
    }

    /** @param shown opaque surfaces, nearest first */
    void draw(GL3 gl, RenderTargets targets, List<SurfaceBuffers> shown, ViewTransform transform, SceneStyle style) {
        boolean cut = style.clip().isPresent();
        Map<Boolean, List<SurfaceBuffers>> still =
                shown.stream().collect(Collectors.partitioningBy(SurfaceBuffers::isStill));
        List<?> view = view(still.get(true), transform, style);
        boolean rests = view.equals(keptView) && !cut && targets.canKeepStill();
        keptView = view;
        if (rests && isKeptIn(targets)) {
            targets.restoreStill(gl);
            prepare(gl, false);
            drawAll(gl, still.get(false), transform, style);
        } else if (rests) {
            begin(gl, targets, transform, style);
            drawAll(gl, still.get(true), transform, style);
            targets.keepStill(gl);
            keptIn = targets;
            drawAll(gl, still.get(false), transform, style);
        } else {
            keptIn = null;
            begin(gl, targets, transform, style);
            drawAll(gl, shown, transform, style);
        }
        Renderer.setClipping(gl, false);
        if (cut) {
            caps.draw(gl, shown, faces, transform, style);
        }
    }

    /** Targets of another size are other objects. */
    @SuppressWarnings("ReferenceEquality")
    private boolean isKeptIn(RenderTargets targets) {
        return keptIn == targets;
    }

    private void begin(GL3 gl, RenderTargets targets, ViewTransform transform, SceneStyle style) {
        targets.drawTarget().bind(gl);
        Renderer.setClipping(gl, false);
        gl.glClear(GL3.GL_DEPTH_BUFFER_BIT | GL3.GL_STENCIL_BUFFER_BIT);
        List<?> key = List.of(style.background(), transform.tile());
        targets.background(gl, key, () -> screen.drawBackground(gl, style.background(), transform));
        prepare(gl, style.clip().isPresent());
    }

    private static void prepare(GL3 gl, boolean cut) {
        Renderer.setClipping(gl, cut);
        gl.glEnable(GL3.GL_DEPTH_TEST);
        gl.glDepthFunc(GL3.GL_LESS);
    }

    private void drawAll(GL3 gl, List<SurfaceBuffers> drawn, ViewTransform transform, SceneStyle style) {
        SurfacePass.Faces sides = style.clip().isPresent() ? SurfacePass.Faces.BOTH : SurfacePass.Faces.FRONT;
        drawn.forEach(surface -> faces.draw(gl, surface, transform, style, sides));
    }

    /** All that the picture of still surfaces depends on. */
    private List<?> view(List<SurfaceBuffers> still, ViewTransform transform, SceneStyle style) {
        List<Object> looks = new ArrayList<>();
        for (SurfaceBuffers s : still) {
            String name = s.surface().name();
            Appearance look = style.appearance(name).orElseThrow();
            looks.add(name);
            looks.add(look.packedRgb());
            looks.add(style.showsField(name) ? new Object() : name.equals(style.highlighted()));
        }
        return List.of(transform, style.background(), faces.isCoarse(), looks);
    }
}
