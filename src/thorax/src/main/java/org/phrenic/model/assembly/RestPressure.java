package org.phrenic.model.assembly;

import java.util.Arrays;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.FacePressure;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.SpringList;

/**
 * Equilibrium of the sheet under the pressure at rest: spring tensions ({@link Prestress}) and a constant load for the
 * residual. Both are proportional to the pressure, so the rest shape does not depend on its value.
 */
public final class RestPressure {
    /**
     * Distance over which tensions balance the load, mm. Each conjugate-gradient iteration carries information by one
     * edge. With more, tensions grow while the residual hardly decreases.
     */
    private static final double REACH_MM = 210;
    /** Nodes within this distance of the wall are in contact with it at rest. */
    private static final double WALL_CONTACT_MM = 1;

    private static final double MIN_REST_SHARE = 0.3;
    private static final double DOME_RADIUS_MM = 70;

    private final double nominal;
    private final double shareAtAssembly;
    private final double[] tension;
    private final ConstantLoad load;
    private final double residual;

    /**
     * Sets the rest lengths of the sheet's springs for the pressure at rest, and adds the constant load to the scene.
     *
     * @param pressure on the abdominal face; left at a positive pressure
     * @param atRest kPa, 0 for no pressure
     * @param usual kPa, used to compute the tensions if {@code atRest} is 0
     * @param leans whether the sheet is in contact with the chest wall
     */
    public RestPressure(Scene scene, FacePressure pressure, double atRest, double usual, boolean leans) {
        DiaphragmPart diaphragm = scene.diaphragm();
        SpringList springs = scene.nodes().sheetSprings;
        // Without pressure at first, tensions are computed for when it is turned on.
        nominal = atRest > 0 ? atRest : usual;
        shareAtAssembly = atRest / nominal;
        double[] pressing = load(scene, pressure);
        boolean[] free = new boolean[scene.layout().nodeCount()];
        int vertices = diaphragm.diaphragm.sheet().vertexCount();
        for (int i = 0; i < vertices; i++) {
            free[diaphragm.firstNode + i] = !diaphragm.diaphragm.isInserted(i);
        }
        int count = springs.count();
        double[] solved = scene.computed().get("rest pressure", count + pressing.length, () -> {
            double[] normals = wallNormals(scene, diaphragm, leans);
            return solve(
                    new Prestress(scene.restPositions(), springs.nodeA(), springs.nodeB(), free, normals),
                    springs,
                    pressing,
                    Math.sqrt(MeshMeasure.area(diaphragm.diaphragm.sheet()) / vertices));
        });
        tension = Arrays.copyOf(solved, count);
        setRestLengths(springs);
        double[] left = Arrays.copyOfRange(solved, count, solved.length);
        residual = shareAtAssembly > 0 ? relativeResidual(left, pressing, free) : 0;
        Arrays.setAll(left, i -> -left[i]);
        load = new ConstantLoad(scene.layout(), left);
        load.setLoadFactor(shareAtAssembly);
        scene.system().add(load);
    }

    /** The tension of each spring before the limit of its rest length, then the forces that stay unbalanced, mN. */
    private double[] solve(Prestress solver, SpringList springs, double[] pressing, double spacing) {
        double[] solved = new double[springs.count()];
        // Laplace's law for a dome, shared by the two faces, times the width of tissue that an edge represents.
        Arrays.fill(solved, nominal * DOME_RADIUS_MM / 2 / 2 * spacing);
        solver.solve(pressing, solved, (int) Math.round(REACH_MM / spacing));
        double[] limited = new double[solved.length];
        double[] stiffness = springs.stiffness();
        double[] length = springs.rest();
        for (int e = 0; e < solved.length; e++) {
            double rest = limitedRestLength(length[e], length[e] - solved[e] / stiffness[e]);
            limited[e] = stiffness[e] * (length[e] - rest);
        }
        double[] left = solver.unbalancedForce(pressing, limited);
        double[] both = Arrays.copyOf(solved, solved.length + left.length);
        System.arraycopy(left, 0, both, solved.length, left.length);
        return both;
    }

    /** Nodal forces of the nominal pressure, caller's order, mN. */
    private double[] load(Scene scene, FacePressure pressure) {
        NodeLayout layout = scene.layout();
        double[] internal = new double[3 * layout.nodeCount()];
        pressure.setPressure(nominal);
        for (int block = 0; block < layout.blockCount(); block++) {
            pressure.addForces(scene.system().positions(), scene.system().velocities(), internal, block);
        }
        double[] pressing = new double[internal.length];
        layout.toCaller(internal, pressing);
        return pressing;
    }

    private void setRestLengths(SpringList springs) {
        double[] stiffness = springs.stiffness();
        double[] length = springs.rest();
        for (int e = 0; e < tension.length; e++) {
            double rest = limitedRestLength(length[e], length[e] - tension[e] / stiffness[e]);
            tension[e] = stiffness[e] * (length[e] - rest);
            springs.setRest(e, shareAtAssembly == 1 ? rest : length[e] - shareAtAssembly * tension[e] / stiffness[e]);
        }
    }

    private static double relativeResidual(double[] left, double[] pressing, boolean[] free) {
        double squares = 0;
        double all = 0;
        for (int i = 0; i < left.length; i++) {
            squares += left[i] * left[i];
            all += free[i / 3] ? pressing[i] * pressing[i] : 0;
        }
        return all > 0 ? Math.sqrt(squares / all) : 0;
    }

    /** Rest length limited to a range that leaves room for muscle shortening, mm. */
    public static double limitedRestLength(double length, double rest) {
        return Math.max(MIN_REST_SHARE * length, rest);
    }

    /** Wall normals at nodes in contact with the wall at rest, zero elsewhere. */
    private static double[] wallNormals(Scene scene, DiaphragmPart diaphragm, boolean leans) {
        double[] normals = new double[3 * scene.layout().nodeCount()];
        if (!leans) {
            return normals;
        }
        SlidingSheet sheet = scene.slidingSheet();
        double[] plane = new double[5];
        sheet.wall().prepare(0);
        for (int i = 0; i < sheet.vertices().length; i++) {
            double x = sheet.restPositions()[3 * i];
            double y = sheet.restPositions()[3 * i + 1];
            double z = sheet.restPositions()[3 * i + 2];
            int vertex = sheet.vertices()[i];
            sheet.wall().tangentPlane(i, x, y, z, plane, 0);
            if (diaphragm.diaphragm.isThoracic(vertex)
                    && plane[0] * x + plane[1] * y + plane[2] * z - plane[3] < WALL_CONTACT_MM) {
                System.arraycopy(plane, 0, normals, 3 * (diaphragm.firstNode + vertex), 3);
            }
        }
        return normals;
    }

    /** Share of the load at rest that the constant load carries. */
    public double residual() {
        return residual;
    }

    /** Change of the tension of a sheet spring from that at assembly if the pressure at rest changes, mN. */
    public double additionalTension(int spring, double pressure) {
        return (pressure / nominal - shareAtAssembly) * tension[spring];
    }

    /** Scales the constant load with the pressure at rest, kPa. */
    public void scaleLoad(double pressure) {
        load.setLoadFactor(pressure / nominal);
    }
}
