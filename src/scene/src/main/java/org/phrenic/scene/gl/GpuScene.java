package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.surface.AmbientOcclusion;
import org.phrenic.scene.surface.Markers;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * All surfaces and overlays of a scene on the graphics card, as they are in one frame; sends what has changed since the
 * last.
 */
final class GpuScene {
    private final GlResources objects;
    private final List<SurfaceBuffers> surfaces = new ArrayList<>();
    private final List<OverlayBuffers> overlays = new ArrayList<>();
    private final int nodeBuffer;
    private FloatBuffer nodes = FloatBuffer.allocate(0);
    private boolean nodesUploaded;
    private long step = -1;
    private double time;
    private int nodesHash;
    private String uploadedField = "";

    GpuScene(GL3 gl, GlResources objects, List<Surface> scene, List<Overlay> over) {
        this.objects = objects;
        AmbientOcclusion openness = new AmbientOcclusion(
                scene.stream().filter(s -> !Markers.isMovable(s.name())).toList());
        for (int i = 0; i < scene.size(); i++) {
            surfaces.add(new SurfaceBuffers(gl, objects, scene.get(i), i, openness));
        }
        nodeBuffer = objects.buffer(gl);
        over.forEach(o -> overlays.add(new OverlayBuffers(gl, objects, o, nodeBuffer)));
    }

    /**
     * Takes over a frame.
     *
     * @param given values of {@link ColourField#DISTANCE} by structure
     */
    void update(GL3 gl, Frame frame, SceneStyle style, Map<String, float[]> given, int givenCount) {
        int now = Arrays.hashCode(frame.nodes());
        boolean moved = frame.step() != step || frame.timeS() != time || now != nodesHash;
        if (moved) {
            step = frame.step();
            time = frame.timeS();
            nodesHash = now;
            nodesUploaded = false;
            surfaces.forEach(s -> s.upload(gl, frame));
        }
        if (!style.overlays().isEmpty() && !nodesUploaded) {
            uploadNodes(gl, frame.nodes());
        }
        String wanted = style.field() + " " + style.fieldStructure() + " " + givenCount;
        if (style.field() != ColourField.NONE && (moved || !wanted.equals(uploadedField))) {
            for (SurfaceBuffers s : surfaces) {
                if (style.showsField(s.surface().name())) {
                    s.uploadField(gl, style.field(), given.get(s.surface().name()));
                }
            }
        }
        uploadedField = wanted;
    }

    /** Puts surfaces that stand still where they are said to be. */
    void setPoses(Map<String, float[]> placed) {
        if (!placed.isEmpty()) {
            surfaces.forEach(s -> {
                float[] pose = placed.get(s.surface().name());
                if (pose != null) {
                    s.setPose(pose);
                }
            });
        }
    }

    private void uploadNodes(GL3 gl, float[] at) {
        if (nodes.capacity() != at.length) {
            nodes = Buffers.newDirectFloatBuffer(at.length);
        }
        nodes.put(0, at);
        objects.stream(gl, nodeBuffer, nodes);
        nodesUploaded = true;
    }

    List<SurfaceBuffers> surfaces() {
        return surfaces;
    }

    List<OverlayBuffers> overlays() {
        return overlays;
    }

    void dispose(GL3 gl) {
        surfaces.forEach(s -> s.dispose(gl));
        overlays.forEach(o -> o.dispose(gl));
        objects.deleteBuffer(gl, nodeBuffer);
    }
}
