package org.phrenic.patient.diaphragm;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Unknown structures that go where the lungs go: fluid and air in the pleura by their names, and what lungs surround.
 */
final class ChestContents {
    private static final Pattern IN_PLEURA =
            Pattern.compile(".*(effusion|erguss|empyema|(hydro|ha?emo|pneumo|chylo)thorax"
                    + "|pleura.*(fluid|air|gas|collection)|(fluid|air|gas|collection).*pleura).*");
    private static final Pattern ELSEWHERE =
            Pattern.compile(".*(ascites|periton|abdom|joint|peri[ck]ard|plaque|thicken|parietal).*"
                    + "|(.*_)?(drain(age)?|catheter|tube)s?(_.*)?");
    /** Points nearer to a lung than this touch it, mm. */
    private static final double TOUCH_MM = 5;
    /** Least share of the vertices of a structure that lie in lungs or touch them. */
    private static final double LEAST_TOUCHING = 0.7;

    private final Set<String> names = new HashSet<>();

    ChestContents(List<Structure> structures) {
        List<TriangleTree> lungs = structures.stream()
                .filter(s -> s.kind() == StructureKind.LUNG)
                .map(s -> new TriangleTree(s.mesh()))
                .toList();
        for (Structure s : structures) {
            String name = s.name().toLowerCase(Locale.ROOT);
            boolean named = IN_PLEURA.matcher(name).matches()
                    && !ELSEWHERE.matcher(name).matches();
            if (s.kind() == StructureKind.OTHER && (named || isAmong(s.mesh(), lungs))) {
                names.add(s.name());
            }
        }
    }

    boolean has(Structure s) {
        return names.contains(s.name());
    }

    private static boolean isAmong(TriangleMesh mesh, List<TriangleTree> lungs) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        return LiverContents.isShare(mesh, LEAST_TOUCHING, v -> lungs.stream()
                .anyMatch(lung -> lung.isInside(mesh.x(v), mesh.y(v), mesh.z(v))
                        || (lung.closest(mesh.x(v), mesh.y(v), mesh.z(v), hit)
                                && hit.distanceSquared < TOUCH_MM * TOUCH_MM)));
    }
}
