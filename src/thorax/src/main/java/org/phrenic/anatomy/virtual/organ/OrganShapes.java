package org.phrenic.anatomy.virtual.organ;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureName;
import org.phrenic.anatomy.virtual.shape.MarchingTetrahedra;
import org.phrenic.anatomy.virtual.shape.SurfaceRelaxation;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;

/** Generates the surfaces of a list of organs. Equal measures give bitwise equal meshes. */
public final class OrganShapes {
    private static final int SWEEPS = 2;

    private OrganShapes() {}

    /**
     * Generates the organs in their order: each leaves room for those before it.
     *
     * @param gapMm least distance between an organ and its neighbours
     * @throws IllegalArgumentException if an organ has no room for its volume, or a name is not known
     */
    public static List<Structure> generate(List<OrganParameters> organs, OrganSpace.Cavities cavities, double gapMm) {
        List<OrganField> fields = new ArrayList<>();
        for (OrganParameters organ : organs) {
            fields.add(new OrganField(organ, organ.in().within(cavities, gapMm), fields, gapMm));
        }
        return fields.parallelStream().map(OrganShapes::structure).toList();
    }

    private static Structure structure(OrganField field) {
        String name = field.measures().name();
        StructureName known = StructureName.parse(name)
                .orElseThrow(() -> new IllegalArgumentException(
                        "organs: found the name '" + name + "', expected that of an organ or vessel"));
        return new Structure(name, known.kind(), 0, known.side(), mesh(field));
    }

    private static TriangleMesh mesh(OrganField field) {
        double[] box = field.box();
        TriangleMesh rough = MarchingTetrahedra.surface(
                field,
                Arrays.copyOf(box, 3),
                Arrays.copyOfRange(box, 3, 6),
                field.measures().gridMm());
        return SurfaceRelaxation.relax(ConnectedComponents.largest(rough), SWEEPS, v -> field);
    }
}
