package org.phrenic.study.body;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.phrenic.document.OrderedValues;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.study.ReportValues;

/**
 * The organs of a body at one moment.
 *
 * @param body name of the body
 * @param name "rest", or the preset of the breath at whose full inspiration it is
 * @param volumesMl volume of each organ, ml
 * @param contacts all pairs of organs
 */
record OrganMoment(String body, String name, Map<String, Double> volumesMl, List<OrganContact> contacts) {
    static final String REST = "rest";

    /** Measures the surfaces of a scene. */
    static OrganMoment of(String body, String name, List<Surface> surfaces, List<TriangleMesh> meshes) {
        Map<String, Double> volumes = new TreeMap<>();
        for (int i = 0; i < surfaces.size(); i++) {
            if (OrganContact.isOrgan(surfaces.get(i).kind())) {
                volumes.put(surfaces.get(i).name(), MeshMeasure.signedVolumeMl(meshes.get(i)));
            }
        }
        return new OrganMoment(body, name, volumes, OrganContact.all(surfaces, meshes));
    }

    /** The pair of which a number is greatest. */
    OrganContact most(ToDoubleFunction<OrganContact> number) {
        return contacts.stream().max(Comparator.comparingDouble(number)).orElseThrow();
    }

    boolean isWithin() {
        return contacts.stream().allMatch(OrganContact::isWithin);
    }

    /** The values for JSON. */
    OrderedValues values() {
        return new OrderedValues()
                .with("body", body)
                .with("moment", name)
                .with("volumes_ml", volumesMl)
                .with("pairs", contacts.stream().map(ReportValues::of).toList());
    }
}
