package org.phrenic.scene;

import org.phrenic.geometry.TriangleMesh;
import org.phrenic.geometry.TriangleTree;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Surface;

/**
 * Distance of a surface's vertices from a reference surface, such as the same organ in a scan at another breath level (Villard, Bourne and Bello 2009, fig. 5): the exact distance to the nearest point of the
 * nearest triangle, mm, unsigned.
 */
public final class DistanceField {
    private final TriangleTree reference;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();

    /** @param reference in LPS, mm */
    public DistanceField(TriangleMesh reference) {
        this.reference = new TriangleTree(reference);
    }

    /** Gives a renderer the distances of one of its surfaces as it stands in a frame; a surface it has not is left alone. */
    public void colour(Renderer renderer, Frame frame, String structure) {
        for (int i = 0; i < renderer.surfaces().size(); i++) {
            Surface surface = renderer.surfaces().get(i);
            if (surface.name().equals(structure)) {
                renderer.setField(structure, of(surface, i, frame));
            }
        }
    }

    /**
     * Distances of a surface's vertices, mm.
     *
     * @param index of the surface in the scene
     */
    float[] of(Surface surface, int index, Frame frame) {
        double[] now = new double[surface.rest().positions().length];
        frame.place(surface, index, now);
        float[] out = new float[surface.rest().vertexCount()];
        for (int i = 0; i < out.length; i++) {
            out[i] = distance(now[3 * i], now[3 * i + 1], now[3 * i + 2]);
        }
        return out;
    }

    private float distance(double x, double y, double z) {
        hit.distanceSquared = Double.POSITIVE_INFINITY;
        reference.closest(x, y, z, hit);
        return (float) Math.sqrt(hit.distanceSquared);
    }
}
