package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.surface.AmbientOcclusion;
import org.phrenic.scene.surface.CoarseTriangles;
import org.phrenic.scene.surface.Markers;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/** GPU buffers of all surfaces and overlays of a scene. Uploads only what is visible and has changed. */
final class GpuScene {
    private static final System.Logger LOG = System.getLogger(GpuScene.class.getName());

    private final GlResources resources;
    private final List<SurfaceBuffers> surfaces;
    private final List<OverlayBuffers> overlays;
    private final int nodeBuffer;
    private FloatBuffer nodes = FloatBuffer.allocate(0);
    private final BitSet toUpload = new BitSet();
    private boolean nodesUploaded;
    private long step = -1;
    private double time;
    private int nodesHash;
    private String uploadedField = "";
    private Optional<CompletableFuture<List<int[]>>> coarse = Optional.empty();
    private boolean coarseSet;

    GpuScene(GL3 gl, GlResources resources, List<Surface> scene, List<Overlay> over) {
        this.resources = resources;
        AmbientOcclusion occlusion = new AmbientOcclusion(
                scene.stream().filter(s -> !Markers.isMovable(s.name())).toList());
        surfaces = IntStream.range(0, scene.size())
                .mapToObj(i -> new SurfaceBuffers(gl, resources, scene.get(i), i, occlusion))
                .toList();
        nodeBuffer = resources.create(gl, GlResources.Kind.BUFFER);
        overlays = over.stream()
                .map(o -> new OverlayBuffers(gl, resources, o, nodeBuffer))
                .toList();
    }

    /**
     * Uploads the positions, poses and field values of a frame.
     *
     * @param given values of {@link ColourField#DISTANCE} and {@link ColourField#ACCESS} by structure
     * @param version number that differs whenever {@code given} has changed
     */
    void update(GL3 gl, Frame frame, SceneStyle style, Map<String, float[]> given, int version) {
        int hash = Arrays.hashCode(frame.nodes());
        boolean moved = frame.step() != step || frame.timeS() != time || hash != nodesHash;
        if (moved) {
            step = frame.step();
            time = frame.timeS();
            nodesHash = hash;
            nodesUploaded = false;
            toUpload.set(0, surfaces.size());
        }
        boolean uploaded = uploadVisible(gl, frame, style);
        if (!style.lines().overlays().isEmpty() && !nodesUploaded) {
            uploadNodes(gl, frame.nodes());
        }
        String wanted = style.field() + " " + style.colouring().structure() + " " + version;
        if (style.field() != ColourField.NONE && (uploaded || !wanted.equals(uploadedField))) {
            for (SurfaceBuffers s : surfaces) {
                if (style.showsField(s.surface().name())) {
                    s.uploadField(gl, style.field(), given.get(s.surface().name()));
                }
            }
        }
        uploadedField = wanted;
    }

    /** Uploads the visible surfaces of a frame that have not been since it came; returns whether there were any. */
    private boolean uploadVisible(GL3 gl, Frame frame, SceneStyle style) {
        boolean any = false;
        for (int i = toUpload.nextSetBit(0); i >= 0; i = toUpload.nextSetBit(i + 1)) {
            SurfaceBuffers s = surfaces.get(i);
            if (style.shows(s.surface().name())) {
                s.upload(gl, frame);
                toUpload.clear(i);
                any = true;
            }
        }
        return any;
    }

    /**
     * Whether surfaces can be drawn with fewer triangles. The first call begins to compute these on another thread;
     * they are there some pictures later.
     */
    boolean hasCoarse(GL3 gl) {
        if (coarse.isEmpty()) {
            coarse = Optional.of(CompletableFuture.supplyAsync(
                    () -> surfaces.stream().map(GpuScene::fewerTriangles).toList()));
        }
        if (!coarseSet && coarse.get().isDone() && !coarse.get().isCompletedExceptionally()) {
            List<int[]> fewer = coarse.get().join();
            for (int i = 0; i < fewer.size(); i++) {
                surfaces.get(i).setCoarse(gl, fewer.get(i));
            }
            coarseSet = true;
        }
        return coarseSet;
    }

    private static int[] fewerTriangles(SurfaceBuffers surface) {
        return fewerTriangles(surface.surface().name(), surface.outward(), CoarseTriangles::of);
    }

    /** A surface that cannot be decimated, for lack of memory too, keeps all its triangles. */
    static int[] fewerTriangles(String name, TriangleMesh mesh, Function<TriangleMesh, int[]> decimation) {
        try {
            return decimation.apply(mesh);
        } catch (RuntimeException | OutOfMemoryError e) {
            LOG.log(System.Logger.Level.WARNING, name + " is always drawn with all its triangles", e);
            return mesh.triangles();
        }
    }

    /** Waits until fewer triangles have been computed, if that has begun. */
    void awaitCoarse() {
        coarse.ifPresent(CompletableFuture::join);
    }

    void setPoses(Map<String, float[]> poses) {
        for (SurfaceBuffers s : surfaces) {
            float[] pose = poses.get(s.surface().name());
            if (pose != null) {
                s.setPose(pose);
            }
        }
    }

    private void uploadNodes(GL3 gl, float[] at) {
        if (nodes.capacity() != at.length) {
            nodes = Buffers.newDirectFloatBuffer(at.length);
        }
        nodes.put(0, at);
        resources.stream(gl, nodeBuffer, nodes);
        nodesUploaded = true;
    }

    List<SurfaceBuffers> surfaces() {
        return surfaces;
    }

    List<OverlayBuffers> overlays() {
        return overlays;
    }
}
