package org.phrenic.model.organ;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.ejml.data.DMatrix3;
import org.ejml.data.DMatrix3x3;
import org.ejml.dense.fixed.CommonOps_DDF3;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * The liver under the diaphragm: hung from the bare area behind by its ligaments, turned by the roof that lies on it.
 * It is carried, not stepped.
 *
 * <p>With {@code u} the displacement of the roof's points at {@code r} from the middle {@code c} of the bare area,
 * {@code w} their areas and {@code T} the mean of {@code u} over the bare area, the turn {@code ω} is that of least
 * squares, held back by the organs below as by a spring against turning:
 *
 * <p>{@code min Σ w |u - T - ω × r|² + β ρ² |ω|² Σ w}, {@code ρ² = 2/3} of the mean {@code |r|²}; {@code x = X + T +
 * (R(ω) - 1)(X - c)}.
 *
 * <p>What goes up and down does so wholly at the liver's top and less toward its lower edge, for it is soft and lies on
 * the gut (the lower right lobe moves 0.6 to 0.7 times as far as the dome; physiology D1).
 *
 * <p>Where the diaphragm's abdominal face would then stand within it, it gives way ({@link LiverIndentation}): carried
 * stiffly, its front would come through the costal part of the muscle in a deep breath.
 */
public final class LiverPart {
    /**
     * What of the roof is this near to the liver at rest lies on it; behind, it is the bare area with the coronary
     * ligament.
     */
    private static final double ATTACHED_MM = 10;

    /** The abdominal face of the roof looks down. */
    private static final double ROOF = -0.5;

    /** β: how much the organs below hold back the turn, against what the roof asks; chosen. */
    private static final double ROTATION_RESISTANCE = 0.6;

    private static final double LOWEST_SHARE = 0.82;
    private static final int FEWEST = 12;

    /** What of the diaphragm is farther from the liver at rest never comes to it. */
    private static final double REACH_MM = 80;

    /**
     * Turns of the fixed point that finds where a place of the sheet is in the liver as it is at rest; each is five
     * times nearer.
     */
    private static final int INVERSIONS = 4;

    public final Structure structure;
    private final int[] roofNodes;
    private final double[] area;
    private final boolean[] inBareArea;
    private final double bareArea;
    private final double[] centre = new double[3];
    private final DMatrix3x3 resistance = new DMatrix3x3();
    private final LiverIndentation indentation;
    private final int[] abdominalFace;
    private final double lowest;
    private final double height;
    private final double[] moved;
    private final double[] displacement = new double[3];
    private double sincTerm;
    private double cosineTerm;
    private final double[] shift = new double[3];
    private final DMatrix3 moment = new DMatrix3();
    private final DMatrix3 turn = new DMatrix3();

    public LiverPart(Structure liver, DiaphragmPart part) {
        structure = liver;
        TriangleMesh mesh = liver.mesh();
        Diaphragm d = part.diaphragm;
        TriangleMesh sheet = d.sheet();
        NearestVertex surface = new NearestVertex(mesh, i -> true);
        // The thoracic face has no part in it.
        double[] distance = new double[sheet.vertexCount()];
        for (int i = 0; i < distance.length; i++) {
            if (!d.isThoracic(i)) {
                surface.find(sheet.x(i), sheet.y(i), sheet.z(i), REACH_MM);
                distance[i] = surface.distance();
            }
        }
        double[] normals = MeshMeasure.vertexNormals(sheet);
        double[] box = mesh.bounds();
        double middle = 0.5 * (box[1] + box[4]);
        int[] near = roofNodes(d, normals, distance, ATTACHED_MM);
        long behind = IntStream.of(near).filter(i -> sheet.y(i) > middle).count();
        int[] vertices = behind >= FEWEST ? near : roofNodes(d, normals, distance, 3 * ATTACHED_MM);
        double[] areas = MeshMeasure.vertexAreas(sheet);
        area = IntStream.of(vertices).mapToDouble(i -> areas[i]).toArray();
        roofNodes = IntStream.of(vertices).map(i -> 3 * (part.firstNode + i)).toArray();
        inBareArea = new boolean[roofNodes.length];
        double all = 0;
        for (int k = 0; k < roofNodes.length; k++) {
            inBareArea[k] = sheet.y(vertices[k]) > middle;
            all += inBareArea[k] ? area[k] : 0;
        }
        bareArea = all;
        moved = mesh.positions().clone();
        lowest = box[2];
        height = box[5] - box[2];
        int[] abdominal = IntStream.range(0, distance.length)
                .filter(i -> !d.isThoracic(i) && distance[i] < REACH_MM)
                .toArray();
        abdominalFace =
                IntStream.of(abdominal).map(i -> 3 * (part.firstNode + i)).toArray();
        indentation = new LiverIndentation(mesh);
        for (int i : abdominal) {
            indentation.allowRestDepth(sheet.x(i), sheet.y(i), sheet.z(i));
        }
        if (bareArea > 0) {
            measure(sheet.positions(), vertices);
        }
    }

    private static int[] roofNodes(Diaphragm d, double[] normals, double[] distance, double reach) {
        return IntStream.range(0, distance.length)
                .filter(i -> !d.isThoracic(i) && !d.isInserted(i) && normals[3 * i + 2] < ROOF && distance[i] < reach)
                .toArray();
    }

    /** Forms the middle of the bare area and the inverse of what stands before ω. */
    private void measure(double[] p, int[] vertices) {
        for (int k = 0; k < vertices.length; k++) {
            for (int axis = 0; axis < 3 && inBareArea[k]; axis++) {
                centre[axis] += area[k] * p[3 * vertices[k] + axis] / bareArea;
            }
        }
        for (int k = 0; k < vertices.length; k++) {
            double x = p[3 * vertices[k]] - centre[0];
            double y = p[3 * vertices[k] + 1] - centre[1];
            double z = p[3 * vertices[k] + 2] - centre[2];
            double w = area[k];
            resistance.a11 += w * (y * y + z * z);
            resistance.a22 += w * (x * x + z * z);
            resistance.a33 += w * (x * x + y * y);
            resistance.a12 -= w * x * y;
            resistance.a13 -= w * x * z;
            resistance.a23 -= w * y * z;
        }
        double held = ROTATION_RESISTANCE * (resistance.a11 + resistance.a22 + resistance.a33) / 3;
        resistance.a11 += held;
        resistance.a22 += held;
        resistance.a33 += held;
        resistance.a21 = resistance.a12;
        resistance.a31 = resistance.a13;
        resistance.a32 = resistance.a23;
        CommonOps_DDF3.invert(resistance, resistance);
    }

    /** Shares a mass among the nodes of the roof by their area, adding to what each node of the scene carries. */
    public void hang(double mass, double[] carried) {
        double all = Arrays.stream(area).sum();
        for (int k = 0; k < roofNodes.length; k++) {
            carried[roofNodes[k] / 3] += mass * area[k] / all;
        }
    }

    /**
     * Where the liver's vertices are; valid until the next call. Allocates nothing.
     *
     * @param rest positions of the whole scene at rest, caller's order
     * @param now positions of the whole scene now
     */
    public double[] positions(double[] rest, double[] now) {
        if (bareArea == 0) {
            return moved;
        }
        updateRigidMotion(rest, now);
        boolean pressed = indentation(now);
        double[] start = structure.mesh().positions();
        for (int i = 0; i < start.length; i += 3) {
            double x = start[i];
            double y = start[i + 1];
            double z = start[i + 2];
            if (pressed) {
                indentation.at(x, y, z, displacement);
                x += displacement[0];
                y += displacement[1];
                z += displacement[2];
            }
            displace(x, y, z);
            moved[i] = x + displacement[0];
            moved[i + 1] = y + displacement[1];
            moved[i + 2] = z + displacement[2];
        }
        return moved;
    }

    /**
     * Presses the face of the diaphragm, seen from the liver as it is at rest, into that; whether it gives way
     * anywhere.
     */
    private boolean indentation(double[] now) {
        indentation.clear();
        for (int i : abdominalFace) {
            double x = now[i] - shift[0];
            double y = now[i + 1] - shift[1];
            double z = now[i + 2] - shift[2];
            double change = Double.POSITIVE_INFINITY;
            for (int turns = 0; turns < INVERSIONS && !indentation.isBeyond(x, y, z, change); turns++) {
                displace(x, y, z);
                change = Math.abs(now[i] - displacement[0] - x)
                        + Math.abs(now[i + 1] - displacement[1] - y)
                        + Math.abs(now[i + 2] - displacement[2] - z);
                x = now[i] - displacement[0];
                y = now[i + 1] - displacement[1];
                z = now[i + 2] - displacement[2];
            }
            indentation.indent(x, y, z);
        }
        return indentation.relax();
    }

    /**
     * How a place of the liver at rest is carried by shift and turn. Rodrigues: (R - 1) r = sin θ / θ ω × r + (1 - cos
     * θ) / θ² ω × (ω × r).
     */
    private void displace(double px, double py, double pz) {
        double x = px - centre[0];
        double y = py - centre[1];
        double z = pz - centre[2];
        double ax = turn.a2 * z - turn.a3 * y;
        double ay = turn.a3 * x - turn.a1 * z;
        double az = turn.a1 * y - turn.a2 * x;
        double up = Math.max(0, Math.min(1, (pz - lowest) / height));
        double share = LOWEST_SHARE + (1 - LOWEST_SHARE) * up * up * (3 - 2 * up);
        displacement[0] = shift[0] + sincTerm * ax + cosineTerm * (turn.a2 * az - turn.a3 * ay);
        displacement[1] = shift[1] + sincTerm * ay + cosineTerm * (turn.a3 * ax - turn.a1 * az);
        displacement[2] = share * (shift[2] + sincTerm * az + cosineTerm * (turn.a1 * ay - turn.a2 * ax));
    }

    /** Forms shift and turn. */
    private void updateRigidMotion(double[] rest, double[] now) {
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            for (int k = 0; k < roofNodes.length; k++) {
                sum += inBareArea[k] ? area[k] * (now[roofNodes[k] + axis] - rest[roofNodes[k] + axis]) : 0;
            }
            shift[axis] = sum / bareArea;
        }
        moment.setTo(0, 0, 0);
        for (int k = 0; k < roofNodes.length; k++) {
            int i = roofNodes[k];
            double x = rest[i] - centre[0];
            double y = rest[i + 1] - centre[1];
            double z = rest[i + 2] - centre[2];
            double ux = now[i] - rest[i] - shift[0];
            double uy = now[i + 1] - rest[i + 1] - shift[1];
            double uz = now[i + 2] - rest[i + 2] - shift[2];
            moment.a1 += area[k] * (y * uz - z * uy);
            moment.a2 += area[k] * (z * ux - x * uz);
            moment.a3 += area[k] * (x * uy - y * ux);
        }
        CommonOps_DDF3.mult(resistance, moment, turn);
        double angle = Math.sqrt(turn.a1 * turn.a1 + turn.a2 * turn.a2 + turn.a3 * turn.a3);
        sincTerm = angle > 0 ? StrictMath.sin(angle) / angle : 1;
        cosineTerm = angle > 0 ? (1 - StrictMath.cos(angle)) / (angle * angle) : 0.5;
    }
}
