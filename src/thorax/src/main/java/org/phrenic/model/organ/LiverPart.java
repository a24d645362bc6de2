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
 * The liver under the diaphragm, suspended by the ligaments of the bare area at the back and rotated by the diaphragm
 * above. Its motion is computed from that of the diaphragm; it is not part of the stepped system.
 *
 * <p>Let {@code u} be the displacement of the diaphragm's points at {@code r} from the centre {@code c} of the bare
 * area, {@code w} their areas and {@code T} the mean of {@code u} over the bare area. The rotation {@code ω} is a
 * least-squares fit. The organs below resist it like a rotational spring:
 *
 * <p>{@code min Σ w |u - T - ω × r|² + β ρ² |ω|² Σ w}, {@code ρ² = 2/3} of the mean {@code |r|²}; {@code x = X + T +
 * (R(ω) - 1)(X - c)}.
 *
 * <p>Vertical motion is complete at the top of the liver and decreases toward its lower edge, because the liver is soft
 * and rests on the gut. The lower right lobe moves 0.6 to 0.7 times as far as the dome (physiology D1).
 *
 * <p>Where the abdominal face of the diaphragm would penetrate the liver, the liver is indented
 * ({@link LiverIndentation}). A rigid liver would protrude through the costal muscle at the front in a deep breath.
 */
public final class LiverPart {
    /**
     * Points of the diaphragm within this distance of the liver at rest are in contact with it. At the back this is the
     * bare area with the coronary ligament.
     */
    private static final double ATTACHED_MM = 10;

    /** Largest vertical component of the normal of the abdominal face over the liver: it points down. */
    private static final double ROOF = -0.5;

    /** β: resistance of the organs below to rotation, relative to the least-squares term; chosen. */
    private static final double ROTATION_RESISTANCE = 0.6;

    private static final double LOWEST_SHARE = 0.82;
    /** Points that a rotation is fitted to. */
    private static final int LEAST_POINTS = 3;

    private static final int MIN_BARE_AREA_VERTICES = 12;

    /** Points of the diaphragm farther than this from the liver at rest never touch it. */
    private static final double REACH_MM = 80;

    /**
     * Fixed-point iterations that map a point of the sheet to the rest frame of the liver. Each reduces the error by a
     * factor of five.
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
        // The thoracic face never touches the liver.
        double[] distance = new double[sheet.vertexCount()];
        for (int i = 0; i < distance.length; i++) {
            if (!d.isThoracic(i)) {
                surface.find(sheet.x(i), sheet.y(i), sheet.z(i), REACH_MM);
                distance[i] = surface.distance();
            }
        }
        double[] normals = MeshMeasure.vertexNormals(sheet);
        double[] box = mesh.bounds();
        double[] uprightBox = d.frame().toFrame(mesh).bounds();
        double middle = 0.5 * (uprightBox[1] + uprightBox[4]);
        int[] near = roofNodes(d, normals, distance, ATTACHED_MM);
        long behind = IntStream.of(near).filter(i -> d.upright().y(i) > middle).count();
        int[] vertices = behind >= MIN_BARE_AREA_VERTICES ? near : roofNodes(d, normals, distance, 3 * ATTACHED_MM);
        double[] areas = MeshMeasure.vertexAreas(sheet);
        area = IntStream.of(vertices).mapToDouble(i -> areas[i]).toArray();
        roofNodes = IntStream.of(vertices).map(i -> 3 * (part.firstNode + i)).toArray();
        inBareArea = new boolean[roofNodes.length];
        double all = 0;
        for (int k = 0; k < roofNodes.length; k++) {
            inBareArea[k] = d.upright().y(vertices[k]) > middle;
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
        if (isCarried()) {
            measure(sheet.positions(), vertices);
        }
    }

    private LiverPart(LiverPart like) {
        structure = like.structure;
        roofNodes = like.roofNodes;
        area = like.area;
        inBareArea = like.inBareArea;
        bareArea = like.bareArea;
        System.arraycopy(like.centre, 0, centre, 0, centre.length);
        resistance.setTo(like.resistance);
        indentation = new LiverIndentation(like.indentation);
        abdominalFace = like.abdominalFace;
        lowest = like.lowest;
        height = like.height;
        moved = structure.mesh().positions().clone();
    }

    /** The same liver with working memory of its own, for another thread. */
    public LiverPart copy() {
        return new LiverPart(this);
    }

    /** Whether the diaphragm is near enough to carry this liver; else it stands still. */
    public boolean isCarried() {
        return bareArea > 0 && roofNodes.length >= LEAST_POINTS;
    }

    private static int[] roofNodes(Diaphragm d, double[] normals, double[] distance, double reach) {
        return IntStream.range(0, distance.length)
                .filter(i -> !d.isThoracic(i) && !d.isInserted(i) && normals[3 * i + 2] < ROOF && distance[i] < reach)
                .toArray();
    }

    /** Computes the centre of the bare area and the inverse of the matrix of ω. */
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

    /**
     * Distributes a mass over the diaphragm nodes in contact by area, adding to the mass that each scene node carries.
     * A liver that is not carried hangs from none.
     */
    public void hang(double mass, double[] carried) {
        if (!isCarried()) {
            return;
        }
        double all = Arrays.stream(area).sum();
        for (int k = 0; k < roofNodes.length; k++) {
            carried[roofNodes[k] / 3] += mass * area[k] / all;
        }
    }

    /**
     * Tolerates the sheet's depth in the liver at rest.
     *
     * @param rest positions of the whole scene at rest, caller's order
     */
    public void settleUnder(double[] rest) {
        for (int i : abdominalFace) {
            indentation.allowRestDepth(rest[i], rest[i + 1], rest[i + 2]);
        }
    }

    /**
     * Current positions of the liver's vertices; valid until the next call. Allocates nothing.
     *
     * @param rest positions of the whole scene at rest, caller's order
     * @param now current positions of the whole scene, caller's order
     */
    public double[] positions(double[] rest, double[] now) {
        if (!isCarried()) {
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
     * Indents the liver by the face of the diaphragm, mapped to the liver's rest frame; returns whether it is indented
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
     * Displacement of a point of the liver by translation and rotation. Rodrigues' formula: (R - 1) r = sin θ / θ ω × r
     * + (1 - cos θ) / θ² ω × (ω × r).
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

    /** Updates translation and rotation. */
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
