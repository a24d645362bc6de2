package org.phrenic.access.ultrasound;

import java.util.List;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** A place on the skin where a probe is held. It moves with the skin, and the probe keeps its angles to it. */
public final class ProbeOnSkin {
    /** How deep the middle of the face is pressed in, mm, so that most of the face of a curvilinear probe touches. */
    public static final double PRESS_MM = 6;

    /** The normal is that of the skin within this distance, about the size of the face, mm. */
    private static final double FOOTPRINT_MM = 20;

    private final ScannedSkin skin;
    private final int triangle;
    private final double[] weights;
    private final int[] footprint;

    /**
     * @param surfaces surfaces of a scene, in the order of its frames
     * @param restMm place on the skin at end-expiration, LPS, mm
     * @throws BadInputException if the body has no skin, or the place is more than 5 mm from it
     */
    public ProbeOnSkin(List<Surface> surfaces, double[] restMm) {
        this(new ScannedSkin(surfaces).at(restMm));
    }

    private ProbeOnSkin(ProbeOnSkin like) {
        skin = like.skin;
        triangle = like.triangle;
        weights = like.weights;
        footprint = like.footprint;
    }

    ProbeOnSkin(ScannedSkin skin, TriangleTree.Hit hit) {
        this.skin = skin;
        triangle = hit.triangle;
        weights = new double[] {hit.weightA, hit.weightB, hit.weightC};
        footprint = footprint(skin.rest(), new double[] {hit.x, hit.y, hit.z});
    }

    private int[] footprint(TriangleMesh mesh, double[] at) {
        IntList near = new IntList();
        double[] p = mesh.positions();
        int[] corners = mesh.triangles();
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double squared = 0;
            for (int axis = 0; axis < 3; axis++) {
                double sum = p[3 * corners[3 * t] + axis]
                        + p[3 * corners[3 * t + 1] + axis]
                        + p[3 * corners[3 * t + 2] + axis];
                double off = sum / 3 - at[axis];
                squared += off * off;
            }
            if (t == triangle || squared < FOOTPRINT_MM * FOOTPRINT_MM) {
                near.add(t);
            }
        }
        return near.toArray();
    }

    /** The pose of the probe in a frame. */
    public ProbePose pose(Frame frame, ProbePose.Angles angles) {
        int[] t = skin.rest().triangles();
        double[] at = new double[3];
        for (int k = 0; k < 3; k++) {
            at = Vectors.addScaled(at, corner(frame, t[3 * triangle + k]), weights[k]);
        }
        double[] normal = new double[3];
        for (int f : footprint) {
            double[] a = corner(frame, t[3 * f]);
            double[] ab = Vectors.subtract(corner(frame, t[3 * f + 1]), a);
            double[] ac = Vectors.subtract(corner(frame, t[3 * f + 2]), a);
            normal = Vectors.addScaled(normal, Vectors.cross(ab, ac), skin.outward);
        }
        return ProbePose.onSkin(at, normal, angles, PRESS_MM);
    }

    private double[] corner(Frame frame, int vertex) {
        double[] rest = skin.rest().positions();
        double[] at = {rest[3 * vertex], rest[3 * vertex + 1], rest[3 * vertex + 2]};
        if (skin.surface.motion() == Surface.Motion.RIGID) {
            Frame.transform(frame.pose(skin.index), at.clone(), at);
        } else if (skin.surface.motion() == Surface.Motion.DEFORMING) {
            float[] now = frame.positions(skin.index);
            for (int axis = 0; axis < 3; axis++) {
                at[axis] = now[3 * vertex + axis];
            }
        }
        return at;
    }
}
