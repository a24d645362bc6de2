package org.phrenic.access.ultrasound;

import java.util.List;
import org.phrenic.access.TrunkSkin;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Surface;

/**
 * The skin about the liver of a body, on which places for a probe are found at end-expiration. Its tree is built once.
 */
public final class ScannedSkin {
    private static final double TOLERANCE_MM = 5;
    /** Steps over the curved skin into the plane of a tilted probe. */
    private static final int PLANE_STEPS = 4;

    final Surface surface;
    final int index;
    final double outward;
    private final TriangleTree tree;

    /**
     * @param surfaces surfaces of a scene, in the order of its frames
     * @throws BadInputException if the body has no skin, or several of which none or more than one is about the liver
     */
    public ScannedSkin(List<Surface> surfaces) {
        surface = of(surfaces);
        index = surfaces.indexOf(surface);
        tree = new TriangleTree(surface.rest());
        outward = Math.signum(MeshMeasure.signedVolume(surface.rest()));
    }

    static Surface of(List<Surface> surfaces) {
        return TrunkSkin.of(surfaces)
                .orElseThrow(() -> new BadInputException("the body: found no skin, expected one to put a probe on"));
    }

    TriangleMesh rest() {
        return surface.rest();
    }

    /** The place on the skin nearest to a point. */
    TriangleTree.Hit nearest(double[] restMm) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        tree.closest(restMm[0], restMm[1], restMm[2], hit);
        return hit;
    }

    /** The point of the skin nearest to a point, both at end-expiration, LPS, mm. */
    public double[] nearestPoint(double[] restMm) {
        TriangleTree.Hit hit = nearest(restMm);
        return new double[] {hit.x, hit.y, hit.z};
    }

    /**
     * A point of the skin in the image plane of a probe, at end-expiration, LPS, mm.
     *
     * @param held the probe
     * @param upright the probe with neither tilt nor rock
     * @param place where the middle of its face is, on the skin
     * @param lateralMm how far beside that the point is, toward the marker
     */
    public double[] inImagePlane(ProbePose held, ProbePose upright, double[] place, double lateralMm) {
        double[] elevation = held.elevation();
        double[] sideways = upright.elevation();
        double[] at = nearestPoint(Vectors.addScaled(place, upright.lateral(), lateralMm));
        for (int i = 0; i < PLANE_STEPS; i++) {
            double beside = Vectors.dot(Vectors.subtract(at, held.face()), elevation);
            at = nearestPoint(Vectors.addScaled(at, sideways, -beside / Vectors.dot(elevation, sideways)));
        }
        return at;
    }

    /**
     * A probe on the skin.
     *
     * @param restMm place on the skin at end-expiration, LPS, mm
     * @throws BadInputException if the place is more than {@value #TOLERANCE_MM} mm from the skin
     */
    public ProbeOnSkin at(double[] restMm) {
        TriangleTree.Hit hit = nearest(restMm);
        double distance = Math.sqrt(hit.distanceSquared);
        if (distance > TOLERANCE_MM) {
            throw new BadInputException(Numbers.format(
                    "probe: found (%.1f, %.1f, %.1f), %.1f mm %s, expected a place on the skin; the nearest is"
                            + " %.1f,%.1f,%.1f",
                    restMm[0],
                    restMm[1],
                    restMm[2],
                    distance,
                    tree.isInside(restMm[0], restMm[1], restMm[2]) ? "inside the body" : "off the skin",
                    hit.x,
                    hit.y,
                    hit.z));
        }
        return new ProbeOnSkin(this, hit);
    }
}
