package org.phrenic.scene;

import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Unsigned distance of a surface's vertices from a reference surface, such as the same organ in a scan at another
 * breath level (Villard, Bourne and Bello 2009, fig. 5), to the nearest point of the nearest triangle, mm.
 */
public final class DistanceField {
    private final SurfaceDistance reference;

    /** @param reference in LPS, mm */
    public DistanceField(TriangleMesh reference) {
        this.reference = new SurfaceDistance(reference);
    }

    /** Sets the distances of one of a renderer's surfaces in a frame; does nothing if it has no such surface. */
    public void upload(Renderer renderer, Frame frame, String structure) {
        for (int i = 0; i < renderer.surfaces().size(); i++) {
            Surface surface = renderer.surfaces().get(i);
            if (surface.name().equals(structure)) {
                renderer.setField(structure, distances(surface, i, frame));
            }
        }
    }

    /**
     * Distances of a surface's vertices, mm.
     *
     * @param index of the surface in the scene
     */
    float[] distances(Surface surface, int index, Frame frame) {
        double[] now = new double[surface.rest().positions().length];
        frame.writePositions(surface, index, now);
        return toFloats(reference.unsignedDistance(now));
    }

    static float[] toFloats(double[] values) {
        float[] out = new float[values.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = (float) values[i];
        }
        return out;
    }
}
