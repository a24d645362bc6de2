package org.phrenic.scene;

import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Unsigned distance of each vertex of a surface to the closest point of a reference surface, mm. The reference is, for
 * example, the same organ in a scan at another breath level (Villard, Bourne and Bello 2009, fig. 5).
 */
public final class DistanceField {
    private final SurfaceDistance reference;

    /** @param reference reference surface in LPS, mm */
    public DistanceField(TriangleMesh reference) {
        this.reference = new SurfaceDistance(reference);
    }

    /** Sets the distances of a structure in a renderer. Does nothing if the renderer has no such structure. */
    public void upload(Renderer renderer, Frame frame, String structure) {
        for (int i = 0; i < renderer.surfaces().size(); i++) {
            Surface surface = renderer.surfaces().get(i);
            if (surface.name().equals(structure)) {
                renderer.setField(structure, distances(surface, i, frame));
            }
        }
    }

    /**
     * Distance of each vertex of a surface, mm.
     *
     * @param index index of the surface in the scene
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
