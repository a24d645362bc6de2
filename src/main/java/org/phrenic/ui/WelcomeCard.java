package org.phrenic.ui;

import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;

/** What is seen first beside the breathing thorax: two doors, and what the program is not for. */
final class WelcomeCard extends JPanel {
    private final JLabel[] quiet;

    /**
     * @param enter told through which door someone went
     * @param dismiss called when the card is closed without
     */
    WelcomeCard(Consumer<Arrangement> enter, Runnable dismiss) {
        super(new MigLayout("insets 8 12 8 8, gap 8 2, novisualpadding", "[0::, sg, fill][0::, sg, fill]push[]", ""));
        setName("welcome");
        getAccessibleContext().setAccessibleName("Welcome");
        JButton liver = door(
                Arrangement.CLINICIAN,
                "A needle to a target in a liver that moves with the breath, without terms of physics",
                enter);
        JButton tune = door(Arrangement.RESEARCHER, "Every parameter, force and plot", enter);
        JButton close = new JButton(Icons.CLOSE);
        close.putClientProperty("JButton.buttonType", "toolBarButton");
        close.setToolTipText("Close this card");
        close.getAccessibleContext().setAccessibleName("Close this card");
        close.addActionListener(e -> dismiss.run());
        JLabel underLiver = new JLabel("Needle, target, exercises, report card");
        JLabel underTune = new JLabel("Parameters, forces, live plots");
        JLabel notice = new JLabel(Notice.TEXT);
        notice.setName("notice");
        notice.setFont(notice.getFont().deriveFont(java.awt.Font.BOLD));
        quiet = new JLabel[] {underLiver, underTune};
        add(liver, "wmin 0");
        add(tune, "wmin 0");
        add(close, "aligny top, wrap");
        add(underLiver, "gapx 2, wmin 0");
        add(underTune, "gapx 2, wmin 0, wrap");
        add(notice, "span 3, gapy 4 0, gapx 2, wmin 0");
        colour();
    }

    private static JButton door(Arrangement arrangement, String tip, Consumer<Arrangement> enter) {
        JButton button = new JButton(arrangement.label());
        button.setName("door." + arrangement.name());
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(arrangement.label());
        button.putClientProperty("FlatLaf.styleClass", "h4");
        button.setMargin(new java.awt.Insets(8, 18, 8, 18));
        button.addActionListener(e -> enter.accept(arrangement));
        return button;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (quiet != null) {
            colour();
        }
    }

    private void colour() {
        setBackground(UIManager.getColor("Panel.background"));
        setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.line()));
        for (JLabel label : quiet) {
            label.setForeground(Theme.quietText());
        }
    }
}
