<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Neues Projekt…</translation>
    </message>
    <message>
        <source>Make a project from videos or connected cameras</source>
        <translation>Ein Projekt aus Videos oder angeschlossenen Kameras machen</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ein Projekt öffnen</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Demo öffnen</translation>
    </message>
    <message>
        <source>Open the simulated demo scene</source>
        <translation>Die simulierte Demo-Szene öffnen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Das Projekt unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Close project</source>
        <translation>Projekt schließen</translation>
    </message>
    <message>
        <source>Back to the start page</source>
        <translation>Zurück zur Startseite</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Quit Dewpoint</source>
        <translation>Dewpoint beenden</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Make the change that was taken back again</source>
        <translation>Die zurückgenommene Änderung wieder machen</translation>
    </message>
    <message>
        <source>Shortcuts…</source>
        <translation>Tastenkürzel…</translation>
    </message>
    <message>
        <source>See and change all shortcuts</source>
        <translation>Alle Tastenkürzel sehen und ändern</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>Track one frame and pause</source>
        <translation>Ein Bild verfolgen und anhalten</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Eine Iteration</translation>
    </message>
    <message>
        <source>One filter iteration on the frame shown, and pause</source>
        <translation>Eine Filteriteration auf dem gezeigten Bild, dann anhalten</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Start over with the same random numbers</source>
        <translation>Von vorn beginnen, mit denselben Zufallszahlen</translation>
    </message>
    <message>
        <source>Restart with a new seed</source>
        <translation>Mit neuem Startwert beginnen</translation>
    </message>
    <message>
        <source>Start over with other random numbers</source>
        <translation>Von vorn beginnen, mit anderen Zufallszahlen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Show mask</source>
        <translation>Maske zeigen</translation>
    </message>
    <message>
        <source>Show where the cameras see the target&apos;s color</source>
        <translation>Zeigen, wo die Kameras die Zielfarbe sehen</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view from above: the XY plane</source>
        <translation>Vogelperspektive von oben: die XY-Ebene</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view from the front: the XZ plane</source>
        <translation>Vogelperspektive von vorn: die XZ-Ebene</translation>
    </message>
    <message>
        <source>Search actions…</source>
        <translation>Aktionen suchen…</translation>
    </message>
    <message>
        <source>Find any action by its name</source>
        <translation>Jede Aktion nach ihrem Namen finden</translation>
    </message>
    <message>
        <source>Put all views back where they were at first</source>
        <translation>Alle Ansichten dorthin, wo sie anfangs waren</translation>
    </message>
    <message>
        <source>Colors of the system</source>
        <translation>Farben des Systems</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Light colors</source>
        <translation>Helle Farben</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Dark colors</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>Remove the target</source>
        <translation>Ziel entfernen</translation>
    </message>
    <message>
        <source>Stop following the target that is chosen</source>
        <translation>Das gewählte Ziel nicht mehr verfolgen</translation>
    </message>
    <message>
        <source>Learn the color</source>
        <translation>Farbe lernen</translation>
    </message>
    <message>
        <source>Then click the target in a camera image: its color is learned</source>
        <translation>Danach das Ziel in einem Kamerabild anklicken: Seine Farbe wird gelernt</translation>
    </message>
    <message>
        <source>Add a target</source>
        <translation>Ziel hinzufügen</translation>
    </message>
    <message>
        <source>Follow one more thing: click it in a camera image</source>
        <translation>Noch etwas verfolgen: es in einem Kamerabild anklicken</translation>
    </message>
    <message>
        <source>Export trajectory…</source>
        <translation>Bahn exportieren…</translation>
    </message>
    <message>
        <source>Write the trajectory so far for another program</source>
        <translation>Die bisherige Bahn für ein anderes Programm schreiben</translation>
    </message>
    <message>
        <source>Save a picture of a view…</source>
        <translation>Bild einer Ansicht speichern…</translation>
    </message>
    <message>
        <source>Save a camera image, the bird&apos;s-eye view or a plot as PNG</source>
        <translation>Ein Kamerabild, die Vogelschau oder eine Kurve als PNG speichern</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Voriges Bild</translation>
    </message>
    <message>
        <source>Show the frame before this one as it was</source>
        <translation>Das Bild davor zeigen, wie es war</translation>
    </message>
    <message>
        <source>Back to now</source>
        <translation>Zurück zum Jetzt</translation>
    </message>
    <message>
        <source>Show again where the run stands</source>
        <translation>Wieder zeigen, wo der Lauf steht</translation>
    </message>
    <message>
        <source>Track again from here</source>
        <translation>Ab hier erneut verfolgen</translation>
    </message>
    <message>
        <source>Track again from the moment shown, with the method, parameters and colors of now; pausing stops it</source>
        <translation>Ab dem gezeigten Moment erneut verfolgen, mit Verfahren, Parametern und Farben von jetzt; Pause hält an</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>Diesen Moment markieren</translation>
    </message>
    <message>
        <source>Put a named mark on the moment shown</source>
        <translation>Dem gezeigten Moment eine benannte Marke geben</translation>
    </message>
    <message>
        <source>Remove the mark</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Take the mark away from the moment shown</source>
        <translation>Die Marke vom gezeigten Moment nehmen</translation>
    </message>
    <message>
        <source>Previous mark</source>
        <translation>Vorige Marke</translation>
    </message>
    <message>
        <source>Show the moment of the mark before this one</source>
        <translation>Den Moment der vorigen Marke zeigen</translation>
    </message>
    <message>
        <source>Next mark</source>
        <translation>Nächste Marke</translation>
    </message>
    <message>
        <source>Show the moment of the next mark</source>
        <translation>Den Moment der nächsten Marke zeigen</translation>
    </message>
    <message>
        <source>Zoom to the selected span</source>
        <translation>Auf die gewählte Spanne zoomen</translation>
    </message>
    <message>
        <source>Let the timeline show the selected span only</source>
        <translation>Die Zeitleiste nur die gewählte Spanne zeigen lassen</translation>
    </message>
    <message>
        <source>Show evidence</source>
        <translation>Belege zeigen</translation>
    </message>
    <message>
        <source>Show how likely the cameras find each place around the target, and which places were considered</source>
        <translation>Zeigen, für wie wahrscheinlich die Kameras jeden Ort um das Ziel halten und welche Orte erwogen wurden</translation>
    </message>
    <message>
        <source>Show best particle</source>
        <translation>Bestes Partikel zeigen</translation>
    </message>
    <message>
        <source>Mark the particle of highest weight (MAP) of each target with a triangle, in all views</source>
        <translation>Das Partikel mit dem höchsten Gewicht (MAP) jedes Ziels in allen Ansichten mit einem Dreieck markieren</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Plot spread</source>
        <translation>Streuung zeigen</translation>
    </message>
    <message>
        <source>Standard deviation of the particles along x, y and z</source>
        <translation>Standardabweichung der Partikel entlang x, y und z</translation>
    </message>
    <message>
        <source>Plot effective sample size</source>
        <translation>Effektive Stichprobengröße zeigen</translation>
    </message>
    <message>
        <source>How many particles the weighted ones are worth, and how many there are</source>
        <translation>Wie viele Partikel die gewichteten wert sind und wie viele es gibt</translation>
    </message>
    <message>
        <source>Plot likelihood</source>
        <translation>Likelihood zeigen</translation>
    </message>
    <message>
        <source>What each camera says of the estimate: its log likelihood</source>
        <translation>Was jede Kamera zur Schätzung sagt: ihre Log-Likelihood</translation>
    </message>
    <message>
        <source>Plot existence</source>
        <translation>Existenz zeigen</translation>
    </message>
    <message>
        <source>Probability that the target is at the estimate, by all cameras and by each alone</source>
        <translation>Wahrscheinlichkeit, dass das Ziel an der Schätzung ist, nach allen Kameras und nach jeder allein</translation>
    </message>
    <message>
        <source>Plot error</source>
        <translation>Fehler zeigen</translation>
    </message>
    <message>
        <source>Distance of the estimate from the truth, where it is known</source>
        <translation>Abstand der Schätzung von der Wahrheit, wo sie bekannt ist</translation>
    </message>
    <message>
        <source>Plot time per step</source>
        <translation>Zeit pro Schritt zeigen</translation>
    </message>
    <message>
        <source>Microseconds that each filter iteration took, per target</source>
        <translation>Mikrosekunden, die jede Filteriteration je Ziel dauerte</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über die Zeit</translation>
    </message>
    <message>
        <source>Plot over seconds instead of filter iterations</source>
        <translation>Über Sekunden statt Filteriterationen auftragen</translation>
    </message>
    <message>
        <source>Whole run</source>
        <translation>Ganzer Lauf</translation>
    </message>
    <message>
        <source>Plot the whole run again (double click does the same)</source>
        <translation>Wieder den ganzen Lauf zeigen (ein Doppelklick tut dasselbe)</translation>
    </message>
    <message>
        <source>Copy plots as CSV</source>
        <translation>Kurven als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the numbers of the plots shown, as a table</source>
        <translation>Die Zahlen der gezeigten Kurven als Tabelle kopieren</translation>
    </message>
    <message>
        <source>Save plots as picture…</source>
        <translation>Kurven als Bild speichern…</translation>
    </message>
    <message>
        <source>Save the plots as shown, as SVG or PNG</source>
        <translation>Die Kurven wie gezeigt als SVG oder PNG speichern</translation>
    </message>
    <message>
        <source>Copy trajectory as CSV</source>
        <translation>Bahn als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the selected rows of the trajectory, or all</source>
        <translation>Die gewählten Zeilen der Bahn kopieren, oder alle</translation>
    </message>
    <message>
        <source>Calibrate by hand…</source>
        <translation>Von Hand kalibrieren…</translation>
    </message>
    <message>
        <source>Adjust cameras until a grid lies on the real thing in their images</source>
        <translation>Kameras einstellen, bis ein Gitter in ihren Bildern auf dem Wirklichen liegt</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Kalibrierung importieren…</translation>
    </message>
    <message>
        <source>Take the cameras&apos; calibration from a file of any tool</source>
        <translation>Die Kalibrierung der Kameras aus einer Datei irgendeines Programms nehmen</translation>
    </message>
    <message>
        <source>Export calibration…</source>
        <translation>Kalibrierung exportieren…</translation>
    </message>
    <message>
        <source>Write the cameras&apos; calibration for another tool</source>
        <translation>Die Kalibrierung der Kameras für ein anderes Programm schreiben</translation>
    </message>
    <message>
        <source>Calibrate by waving…</source>
        <translation>Durch Schwenken kalibrieren…</translation>
    </message>
    <message>
        <source>Refine cameras with a waved ball, or a stick with two balls</source>
        <translation>Kameras mit einem geschwenkten Ball oder einem Stab mit zwei Bällen verfeinern</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Calibrate with a board…</source>
        <translation>Mit einer Tafel kalibrieren…</translation>
    </message>
    <message>
        <source>Find lenses and places of the cameras with a printed board</source>
        <translation>Objektive und Standorte der Kameras mit einer gedruckten Tafel finden</translation>
    </message>
    <message>
        <source>Print a calibration board…</source>
        <translation>Kalibriertafel drucken…</translation>
    </message>
    <message>
        <source>Write the board to calibrate with as a PDF in its true size</source>
        <translation>Die Tafel zum Kalibrieren in wahrer Größe als PDF schreiben</translation>
    </message>
    <message>
        <source>Plan the rig…</source>
        <translation>Den Aufbau planen…</translation>
    </message>
    <message>
        <source>See how well the cameras will measure, and where one more would help</source>
        <translation>Sehen, wie gut die Kameras messen werden und wo eine weitere hülfe</translation>
    </message>
    <message>
        <source>Show the map of expected errors</source>
        <translation>Die Karte der erwarteten Fehler zeigen</translation>
    </message>
    <message>
        <source>Show in the bird&apos;s-eye view how far off a target is expected to be at each place</source>
        <translation>In der Vogelperspektive zeigen, wie weit ein Ziel an jedem Ort voraussichtlich danebenliegt</translation>
    </message>
    <message>
        <source>Add a camera to plan</source>
        <translation>Eine Kamera einplanen</translation>
    </message>
    <message>
        <source>Add a camera that is not there yet, to be dragged about</source>
        <translation>Eine Kamera hinzufügen, die es noch nicht gibt, zum Umherziehen</translation>
    </message>
    <message>
        <source>Re-solve the bumped camera</source>
        <translation>Die verdrehte Kamera neu bestimmen</translation>
    </message>
    <message>
        <source>Calibrate the camera that was turned during the run as it stands now; all others stay</source>
        <translation>Die Kamera, die während des Laufs verdreht wurde, so kalibrieren, wie sie jetzt steht; alle anderen bleiben</translation>
    </message>
    <message>
        <source>Find the best place for one more camera</source>
        <translation>Den besten Ort für eine weitere Kamera suchen</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the place from which one more camera helps most</source>
        <translation>An Wänden und Decke den Ort suchen, von dem eine weitere Kamera am meisten hilft</translation>
    </message>
    <message>
        <source>Experiments…</source>
        <translation>Experimente …</translation>
    </message>
    <message>
        <source>Make the figures of the papers anew, with a report</source>
        <translation>Die Abbildungen der Artikel neu erzeugen, mit einem Bericht</translation>
    </message>
    <message>
        <source>Take a box</source>
        <translation>Rahmen nehmen</translation>
    </message>
    <message>
        <source>Export volumes of people…</source>
        <translation>Volumen der Personen exportieren…</translation>
    </message>
    <message>
        <source>Write places, volumes, hulls and densities on the floor of all people as tables</source>
        <translation>Orte, Volumen, Hüllen und Dichten auf dem Boden aller Personen als Tabellen schreiben</translation>
    </message>
    <message>
        <source>A person stands here…</source>
        <translation>Hier steht eine Person…</translation>
    </message>
    <message>
        <source>Say where somebody is: by a click on the person in a camera image, or on the floor in the bird&apos;s-eye view</source>
        <translation>Sagen, wo jemand ist: mit einem Klick auf die Person in einem Kamerabild oder auf den Boden in der Vogelperspektive</translation>
    </message>
    <message>
        <source>Remove this person</source>
        <translation>Diese Person entfernen</translation>
    </message>
    <message>
        <source>The person chosen in the table is not there</source>
        <translation>Die in der Tabelle gewählte Person ist nicht da</translation>
    </message>
    <message>
        <source>Show volumes of people</source>
        <translation>Volumen der Personen zeigen</translation>
    </message>
    <message>
        <source>Show the hull that holds 95 % of each person, and the density of each on the floor</source>
        <translation>Die Hülle zeigen, die 95 % jeder Person enthält, und ihre Dichte auf dem Boden</translation>
    </message>
    <message>
        <source>Filter threads…</source>
        <translation>Filter-Threads…</translation>
    </message>
    <message>
        <source>Choose how many threads share the work of the filter</source>
        <translation>Wählen, wie viele Threads sich die Arbeit des Filters teilen</translation>
    </message>
    <message>
        <source>It is here</source>
        <translation>Hier ist es</translation>
    </message>
    <message>
        <source>Drag a target in the camera images to where it is in the frame shown: tracking goes on from there</source>
        <translation>Ein Ziel in den Kamerabildern dorthin ziehen, wo es im gezeigten Bild ist: Von dort wird weiter verfolgt</translation>
    </message>
    <message>
        <source>Remove the correction</source>
        <translation>Die Korrektur entfernen</translation>
    </message>
    <message>
        <source>Take away where you said that the selected target is in the frame shown; without a selected target, of all</source>
        <translation>Wegnehmen, wo das gewählte Ziel nach Ihrer Angabe im gezeigten Bild ist; ohne gewähltes Ziel von allen</translation>
    </message>
    <message>
        <source>Show the volume of interest</source>
        <translation>Den Suchraum zeigen</translation>
    </message>
    <message>
        <source>Show the box in which targets are searched for, in the images and in the bird&apos;s-eye view</source>
        <translation>Den Quader, in dem Ziele gesucht werden, in den Bildern und in der Vogelperspektive zeigen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>Erneut verfolgen</translation>
    </message>
    <message>
        <source>Track all again that is of earlier settings</source>
        <translation>Alles erneut verfolgen, was von früheren Einstellungen stammt</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to 1/30</source>
        <translation>Die Aufnahme langsamer abspielen, bis hinab zu 1/30</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Play the recording faster, up to eight times</source>
        <translation>Die Aufnahme schneller abspielen, bis zu achtmal so schnell</translation>
    </message>
    <message>
        <source>Normal speed</source>
        <translation>Normale Geschwindigkeit</translation>
    </message>
    <message>
        <source>Play the recording as fast as it was filmed</source>
        <translation>Die Aufnahme so schnell abspielen, wie sie gefilmt wurde</translation>
    </message>
    <message>
        <source>Slowly until it converges</source>
        <translation>Langsam, bis es konvergiert</translation>
    </message>
    <message>
        <source>Play the first iterations of a run one by one, until every target is held (five seconds at most)</source>
        <translation>Die ersten Iterationen eines Laufs einzeln abspielen, bis jedes Ziel gehalten ist (höchstens fünf Sekunden)</translation>
    </message>
    <message>
        <source>Show magnifier</source>
        <translation>Lupe zeigen</translation>
    </message>
    <message>
        <source>Enlarge the particles of a target in a corner of the image where they are too close together to be seen</source>
        <translation>Die Partikel eines Ziels in einer Ecke des Bildes vergrößern, wo sie zu dicht beieinander liegen, um sichtbar zu sein</translation>
    </message>
    <message>
        <source>Show lines of sight</source>
        <translation>Sichtlinien zeigen</translation>
    </message>
    <message>
        <source>Draw a line in the bird&apos;s-eye view from each camera to the target: broken where it is hidden from the camera</source>
        <translation>In der Vogelperspektive eine Linie von jeder Kamera zum Ziel zeichnen: gestrichelt, wo es für die Kamera verdeckt ist</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Enlarge the camera image under the pointer, or that of the selected camera (the wheel does the same)</source>
        <translation>Das Kamerabild unter dem Mauszeiger vergrößern, oder das der gewählten Kamera (das Rad tut dasselbe)</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Show more of the camera image under the pointer, or of that of the selected camera</source>
        <translation>Mehr vom Kamerabild unter dem Mauszeiger zeigen, oder von dem der gewählten Kamera</translation>
    </message>
    <message>
        <source>Fit image</source>
        <translation>Bild einpassen</translation>
    </message>
    <message>
        <source>Show all of the camera image again (double click does the same)</source>
        <translation>Wieder das ganze Kamerabild zeigen (ein Doppelklick tut dasselbe)</translation>
    </message>
    <message>
        <source>Top view</source>
        <translation>Ansicht von oben</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>Ansicht von vorn</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view in perspective, free to orbit</source>
        <translation>Vogelperspektive in Perspektive, frei drehbar</translation>
    </message>
    <message>
        <source>Fit everything in view</source>
        <translation>Alles einpassen</translation>
    </message>
    <message>
        <source>Show the whole room in the bird&apos;s-eye view again (double click does the same)</source>
        <translation>Wieder den ganzen Raum in der Vogelperspektive zeigen (ein Doppelklick tut dasselbe)</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Let the window fill the screen, or give it its frame back</source>
        <translation>Das Fenster den Bildschirm füllen lassen oder ihm seinen Rahmen zurückgeben</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Plot position</source>
        <translation>Position zeigen</translation>
    </message>
    <message>
        <source>Position along x, y and z with a band of two standard deviations, and the truth where it is known</source>
        <translation>Position entlang x, y und z mit einem Band von zwei Standardabweichungen, dazu die Wahrheit, wo sie bekannt ist</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Open the manual at the page of the view that is in use</source>
        <translation>Das Handbuch auf der Seite der benutzten Ansicht öffnen</translation>
    </message>
    <message>
        <source>Quick start</source>
        <translation>Schnelleinstieg</translation>
    </message>
    <message>
        <source>What you see in the window, and how to begin in five steps</source>
        <translation>Was im Fenster zu sehen ist und wie man in fünf Schritten beginnt</translation>
    </message>
    <message>
        <source>Legend of the overlays</source>
        <translation>Legende der Einblendungen</translation>
    </message>
    <message>
        <source>What crosses, ellipses and dots in the images mean</source>
        <translation>Was Kreuze, Ellipsen und Punkte in den Bildern bedeuten</translation>
    </message>
    <message>
        <source>About the methods</source>
        <translation>Über die Verfahren</translation>
    </message>
    <message>
        <source>Open the reference of the tracking methods</source>
        <translation>Die Referenz der Verfahren zum Verfolgen öffnen</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Problem melden…</translation>
    </message>
    <message>
        <source>Collect what helps to find a fault, ready to be copied</source>
        <translation>Sammeln, was hilft, einen Fehler zu finden, fertig zum Kopieren</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Über Dewpoint</translation>
    </message>
    <message>
        <source>Version, license, and how to cite Dewpoint</source>
        <translation>Version, Lizenz und wie Dewpoint zitiert wird</translation>
    </message>
    <message>
        <source>Show images in the bird&apos;s-eye view</source>
        <translation>Bilder in der Vogelperspektive zeigen</translation>
    </message>
    <message>
        <source>Show what each camera sees, in the bird&apos;s-eye view, on the pyramid it looks through</source>
        <translation>In der Vogelperspektive zeigen, was jede Kamera sieht, auf der Pyramide, durch die sie blickt</translation>
    </message>
</context>
<context>
    <name>AssessedRegions</name>
    <message>
        <source>matches too</source>
        <translation>passt auch</translation>
    </message>
    <message>
        <source>also the target (Alt-click if not)</source>
        <translation>auch das Ziel (sonst Alt+Klick)</translation>
    </message>
</context>
<context>
    <name>BoardText</name>
    <message>
        <source>%1: rms %2, focal length %3, %4 pictures; known to %5</source>
        <translation>%1: rms %2, Brennweite %3, %4 Bilder; auf %5 bekannt</translation>
    </message>
    <message>
        <source>Corners in only %1 % of its image: show the board in all of it, also tilted.</source>
        <translation>Ecken nur in %1 % des Bildes: die Tafel überall darin zeigen, auch geneigt.</translation>
    </message>
    <message>
        <source>%1 keeps its place: it never saw the board.</source>
        <translation>%1 behält seinen Platz: die Tafel war dort nie zu sehen.</translation>
    </message>
    <message>
        <source>%1: rms %2</source>
        <translation>%1: rms %2</translation>
    </message>
    <message>
        <source>, place ±%1, direction ±%2</source>
        <translation>, Ort ±%1, Richtung ±%2</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>Objektive</translation>
    </message>
    <message>
        <source>%1 keeps its lens: %2</source>
        <translation>%1 behält sein Objektiv: %2</translation>
    </message>
    <message>
        <source>Places: rms %1 over %2 positions of the board</source>
        <translation>Standorte: rms %1 über %2 Lagen der Tafel</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>its left side nearer</source>
        <translation>linke Seite näher</translation>
    </message>
    <message>
        <source>its right side nearer</source>
        <translation>rechte Seite näher</translation>
    </message>
    <message>
        <source>its upper side nearer</source>
        <translation>obere Seite näher</translation>
    </message>
    <message>
        <source>its lower side nearer</source>
        <translation>untere Seite näher</translation>
    </message>
    <message>
        <source>facing the camera</source>
        <translation>zur Kamera gewandt</translation>
    </message>
    <message>
        <source>No image yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>Show it the whole board</source>
        <translation>Ihr die ganze Tafel zeigen</translation>
    </message>
    <message>
        <source>Move the board to: %1</source>
        <translation>Tafel bewegen nach: %1</translation>
    </message>
    <message>
        <source>Tilt it, %1</source>
        <translation>Neigen, %1</translation>
    </message>
    <message>
        <source>Come nearer with the board</source>
        <translation>Näher kommen mit der Tafel</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>Still halten</translation>
    </message>
    <message>
        <source>The image is soft: focus, or more light</source>
        <translation>Das Bild ist unscharf: scharfstellen oder mehr Licht</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ Fertig</translation>
    </message>
    <message>
        <source>✓ All cameras have seen enough together</source>
        <translation>✓ Alle Kameras haben genug gemeinsam gesehen</translation>
    </message>
    <message>
        <source>Show the board to %1 and %2 at once, hold it still, then elsewhere</source>
        <translation>Zeigen Sie die Tafel %1 und %2 zugleich, still gehalten, dann anderswo</translation>
    </message>
    <message>
        <source>no board in sight</source>
        <translation>keine Tafel zu sehen</translation>
    </message>
    <message>
        <source>⚠ soft, edges of %1</source>
        <translation>⚠ unscharf, Kanten von %1</translation>
    </message>
    <message>
        <source>sharp, edges of %1</source>
        <translation>scharf, Kanten von %1</translation>
    </message>
    <message>
        <source>%1 of at least %2 views</source>
        <translation>%1 von mindestens %2 Ansichten</translation>
    </message>
    <message>
        <source>%1 views, known to %2 (wanted: %3)</source>
        <translation>%1 Ansichten, auf %2 bekannt (gewünscht: %3)</translation>
    </message>
    <message>
        <source>● sees the board</source>
        <translation>● sieht die Tafel</translation>
    </message>
    <message>
        <source>○ does not see the board</source>
        <translation>○ sieht die Tafel nicht</translation>
    </message>
    <message>
        <source>%1 views, place known to %2</source>
        <translation>%1 Ansichten, Standort auf %2 bekannt</translation>
    </message>
    <message>
        <source>%1 views with others</source>
        <translation>%1 Ansichten mit anderen</translation>
    </message>
    <message>
        <source>The places were not found: %1</source>
        <translation>Die Standorte wurden nicht gefunden: %1</translation>
    </message>
    <message>
        <source>How good it is cannot be said: too few places were seen by two cameras.</source>
        <translation>Wie gut es ist, lässt sich nicht sagen: zu wenige Orte wurden von zwei Kameras gesehen.</translation>
    </message>
</context>
<context>
    <name>CalibrationFiles</name>
    <message>
        <source>Calibrations (%1)</source>
        <translation>Kalibrierungen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>CalibrationText</name>
    <message>
        <source>Everything fits when %1 and %2 are exchanged: their videos are likely swapped. Exchange the two files.</source>
        <translation>Alles passt, wenn %1 und %2 vertauscht werden: wahrscheinlich sind ihre Videos verwechselt. Tauschen Sie die beiden Dateien.</translation>
    </message>
    <message>
        <source>%1 fits when its video is shifted: it likely shows everything %2 frames late. Synchronize the videos, or let time offsets be found.</source>
        <translation>%1 passt, wenn ihr Video verschoben wird: es zeigt wahrscheinlich alles %2 Bilder zu spät. Synchronisieren Sie die Videos, oder lassen Sie Zeitversätze suchen.</translation>
    </message>
    <message>
        <source>%1 fits when its video is shifted: it likely shows everything %2 frames early. Synchronize the videos, or let time offsets be found.</source>
        <translation>%1 passt, wenn ihr Video verschoben wird: es zeigt wahrscheinlich alles %2 Bilder zu früh. Synchronisieren Sie die Videos, oder lassen Sie Zeitversätze suchen.</translation>
    </message>
    <message>
        <source>%1 fits one place before %2 and another after: it was likely moved or bumped then. Calibrate with the part after it.</source>
        <translation>%1 passt vor %2 an einen Ort und danach an einen anderen: sie wurde da wahrscheinlich bewegt oder angestoßen. Kalibrieren Sie mit dem Teil danach.</translation>
    </message>
    <message>
        <source>%1 fits only with flipped images: its video is likely mirrored or upside down. Set how its images are turned and mirrored.</source>
        <translation>%1 passt nur mit gekippten Bildern: ihr Video ist wahrscheinlich gespiegelt oder steht auf dem Kopf. Stellen Sie ein, wie ihre Bilder gedreht und gespiegelt werden.</translation>
    </message>
    <message>
        <source>%1 fits with a focal length %2 times the given one: its zoom (or a crop) was likely changed. Calibrate its lens again.</source>
        <translation>%1 passt mit dem %2-fachen der angegebenen Brennweite: wahrscheinlich wurde ihr Zoom (oder ein Ausschnitt) geändert. Kalibrieren Sie ihr Objektiv neu.</translation>
    </message>
    <message>
        <source>The lens data of %1 are likely for another resolution: its images are %2 times as large. Convert them, or record at the calibrated size.</source>
        <translation>Die Objektivdaten von %1 gelten wahrscheinlich für eine andere Auflösung: ihre Bilder sind %2-mal so groß. Rechnen Sie sie um, oder nehmen Sie in der kalibrierten Größe auf.</translation>
    </message>
    <message>
        <source>In this volume ±%1 (95 %)</source>
        <translation>In diesem Raum ±%1 (95 %)</translation>
    </message>
    <message>
        <source>, scale ±%1 %</source>
        <translation>, Größe ±%1 %</translation>
    </message>
    <message>
        <source>, scale unknown</source>
        <translation>, Größe unbekannt</translation>
    </message>
    <message>
        <source>, up ±%1</source>
        <translation>, Lot ±%1</translation>
    </message>
    <message>
        <source>, up not measured</source>
        <translation>, Lot nicht gemessen</translation>
    </message>
    <message>
        <source>all cameras</source>
        <translation>alle Kameras</translation>
    </message>
    <message>
        <source>The cameras would all look at the back of the board or floor: its points are likely mirrored. Check the direction of its axes, and that the print is not reversed.</source>
        <translation>Alle Kameras sähen auf die Rückseite der Tafel oder des Bodens: ihre Punkte sind wahrscheinlich gespiegelt. Prüfen Sie die Richtung der Achsen, und dass der Druck nicht seitenverkehrt ist.</translation>
    </message>
    <message>
        <source>The given length is %1 times what the cameras see: millimeters and meters are likely mixed up.</source>
        <translation>Die angegebene Länge ist das %1-fache dessen, was die Kameras sehen: wahrscheinlich sind Millimeter und Meter verwechselt.</translation>
    </message>
    <message>
        <source>The given length is %1 times what the cameras see: it is likely in inches (1 inch = 2.54 cm).</source>
        <translation>Die angegebene Länge ist das %1-fache dessen, was die Kameras sehen: wahrscheinlich ist sie in Zoll (1 Zoll = 2,54 cm).</translation>
    </message>
    <message>
        <source>The corners form a board with %1 in a row: the number of squares is likely wrong. Count them and correct the board.</source>
        <translation>Die Ecken bilden eine Tafel mit %1 in einer Reihe: die Zahl der Felder ist wahrscheinlich falsch. Zählen Sie nach und berichtigen Sie die Tafel.</translation>
    </message>
    <message>
        <source>The board&apos;s squares are given %1 times as large as the cameras see them: measure a row with a ruler (prints are often rescaled).</source>
        <translation>Die Felder der Tafel sind %1-mal so groß angegeben, wie die Kameras sie sehen: messen Sie eine Reihe mit dem Lineal (Drucke werden oft skaliert).</translation>
    </message>
    <message>
        <source>The images fit when shifted by %1 along both axes: a program likely counts pixels from their corners. Convert the principal points.</source>
        <translation>Die Bilder passen, wenn sie um %1 in beiden Achsen verschoben werden: ein Programm zählt Pixel wahrscheinlich von ihren Ecken aus. Rechnen Sie die Hauptpunkte um.</translation>
    </message>
</context>
<context>
    <name>CameraAgreement</name>
    <message>
        <source>millimeters</source>
        <translation>Millimetern</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>Zentimetern</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped, or %3 and %4.</source>
        <translation>%1 und %2 sind anscheinend vertauscht, oder %3 und %4.</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped.</source>
        <translation>%1 und %2 sind anscheinend vertauscht.</translation>
    </message>
    <message>
        <source>%1 or %2 looks at least %3 away from its calibration.</source>
        <translation>%1 oder %2 blickt mindestens %3 neben ihre Kalibrierung.</translation>
    </message>
    <message>
        <source>%1 looks about %2 away from its calibration.</source>
        <translation>%1 blickt etwa %2 neben ihre Kalibrierung.</translation>
    </message>
    <message>
        <source>%1 and %2 do not see the target at one position. Calibrate them again.</source>
        <translation>%1 und %2 sehen das Ziel nicht an derselben Position. Kalibrieren Sie sie neu.</translation>
    </message>
    <message>
        <source>%1 does not agree with the other cameras. Calibrate it again.</source>
        <translation>%1 stimmt mit den anderen Kameras nicht überein. Kalibrieren Sie sie neu.</translation>
    </message>
    <message>
        <source>%1 is about %2 late.</source>
        <translation>%1 ist etwa %2 zu spät.</translation>
    </message>
    <message>
        <source>%1 is about %2 early.</source>
        <translation>%1 ist etwa %2 zu früh.</translation>
    </message>
    <message>
        <source>The calibration seems to be in %1.</source>
        <translation>Die Kalibrierung ist anscheinend in %1 angegeben.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 und %2 haben dieselbe Lage.</translation>
    </message>
    <message>
        <source>Swap %1 and %2</source>
        <translation>%1 und %2 tauschen</translation>
    </message>
    <message>
        <source>Set the delay of %1</source>
        <translation>Verzögerung von %1 einstellen</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Convert to meters</source>
        <translation>In Meter umrechnen</translation>
    </message>
</context>
<context>
    <name>CameraMotion</name>
    <message>
        <source>turned by %1</source>
        <translation>um %1 verdreht</translation>
    </message>
</context>
<context>
    <name>CameraNames</name>
    <message>
        <source>camera %1</source>
        <translation>Kamera %1</translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
</context>
<context>
    <name>ClickRadiusText</name>
    <message>
        <source>Its radius seems to be about %1.</source>
        <translation>Der Radius ist anscheinend etwa %1.</translation>
    </message>
    <message>
        <source>Its radius seems to be about %1, but %2 is given. Is that its diameter?</source>
        <translation>Der Radius ist anscheinend etwa %1, angegeben ist %2. Ist das der Durchmesser?</translation>
    </message>
    <message>
        <source>Its radius seems to be about %1, but %2 is given.</source>
        <translation>Der Radius ist anscheinend etwa %1, angegeben ist %2.</translation>
    </message>
    <message>
        <source>This is a part of something larger of its color: it is followed as a ball with a radius of %1, from where it was marked.</source>
        <translation>Das ist ein Teil von etwas Größerem in dieser Farbe: Er wird als Ball mit einem Radius von %1 verfolgt, von der markierten Stelle an.</translation>
    </message>
</context>
<context>
    <name>ColorLearner</name>
    <message>
        <source>target %1</source>
        <translation>Ziel %1</translation>
    </message>
</context>
<context>
    <name>ColorText</name>
    <message>
        <source>at the top left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>at the top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>at the top right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>at the left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>in the middle</source>
        <translation>in der Mitte</translation>
    </message>
    <message>
        <source>at the right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>at the bottom left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>at the bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>at the bottom right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>Stands out well: %1 of 100.</source>
        <translation>Hebt sich gut ab: %1 von 100.</translation>
    </message>
    <message>
        <source>Stands out: %1 of 100.</source>
        <translation>Hebt sich ab: %1 von 100.</translation>
    </message>
    <message>
        <source>Hard to tell apart: %1 of 100.</source>
        <translation>Schwer zu unterscheiden: %1 von 100.</translation>
    </message>
    <message>
        <source>Hardly stands out: %1 of 100.</source>
        <translation>Hebt sich kaum ab: %1 von 100.</translation>
    </message>
    <message>
        <source>black</source>
        <translation>Schwarzes</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>Graues</translation>
    </message>
    <message>
        <source>white</source>
        <translation>Weißes</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>Braunes</translation>
    </message>
    <message>
        <source>red</source>
        <translation>Rotes</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>Oranges</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>Gelbes</translation>
    </message>
    <message>
        <source>green</source>
        <translation>Grünes</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>Türkises</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>Blaues</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>Violettes</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>Rosafarbenes</translation>
    </message>
    <message>
        <source>Much of the target does not match: Shift-click its light and its dark side.</source>
        <translation>Vieles am Ziel passt nicht: Umschalt-Klick auf seine helle und seine dunkle Seite.</translation>
    </message>
    <message>
        <source>Alt-click what matches too: it can be told apart.</source>
        <translation>Alt-Klick auf das, was auch passt: Es lässt sich unterscheiden.</translation>
    </message>
    <message>
        <source>Cover what has the same color, or take it out of view.</source>
        <translation>Bedecken Sie, was dieselbe Farbe hat, oder nehmen Sie es aus dem Bild.</translation>
    </message>
    <message>
        <source>The target is nearly black here: more light would help.</source>
        <translation>Das Ziel ist hier fast schwarz: Mehr Licht würde helfen.</translation>
    </message>
    <message>
        <source>The target is nearly white here: a shorter exposure would help.</source>
        <translation>Das Ziel ist hier fast weiß: Eine kürzere Belichtung würde helfen.</translation>
    </message>
    <message>
        <source>The target is nearly gray: a stronger color would help.</source>
        <translation>Das Ziel ist fast grau: Eine kräftigere Farbe würde helfen.</translation>
    </message>
    <message>
        <source>This fills much of the image: click the thing itself, or drag a box on it.</source>
        <translation>Das füllt einen großen Teil des Bildes: Klicke das Ding selbst an oder ziehe einen Rahmen darum.</translation>
    </message>
    <message>
        <source>%1 % of the images match. Shift-click the target to learn how well it stands out.</source>
        <translation>%1 % der Bilder passen. Umschalt-Klick auf das Ziel sagt, wie gut es sich abhebt.</translation>
    </message>
    <message>
        <source>%1 % of the background matches too.</source>
        <translation>%1 % des Hintergrunds passen auch.</translation>
    </message>
    <message>
        <source>One sample hardly matches the learned color: much around it looks the same, or it shows something else.</source>
        <translation>Eine Probe passt kaum zum Gelernten: Die Umgebung hat ihre Farbe auch, oder sie zeigt etwas anderes.</translation>
    </message>
    <message>
        <source>Something %1 %2 of %3 matches too.</source>
        <translation>Etwas %1 %2 in %3 passt auch.</translation>
    </message>
    <message>
        <source>Several things have this color: another one would help.</source>
        <translation>Mehrere Dinge haben diese Farbe: Eine andere würde helfen.</translation>
    </message>
    <message>
        <source>Only a speck was clicked: drag a box on the whole thing.</source>
        <translation>Nur ein Fleck wurde angeklickt: Ziehe einen Rahmen um das ganze Ding.</translation>
    </message>
    <message>
        <source>Only %1 % of the target and %2 % of the background match.</source>
        <translation>Nur %1 % des Ziels und %2 % des Hintergrunds passen.</translation>
    </message>
    <message>
        <source>A range for all of the target would match %1 % of the background.</source>
        <translation>Ein Bereich für das ganze Ziel würde auf %1 % des Hintergrunds passen.</translation>
    </message>
    <message numerus="yes">
        <source>%n things have this color and size: follow all of them, or cover the others.</source>
        <translation>
            <numerusform>%n Ding hat diese Farbe und Größe: Verfolgen Sie alle, oder bedecken Sie die anderen.</numerusform>
            <numerusform>%n Dinge haben diese Farbe und Größe: Verfolgen Sie alle, oder bedecken Sie die anderen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Convergence</name>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Convergence in frame %1 (%2)</source>
        <comment>number of a frame, unit</comment>
        <translation>Konvergenz in Bild %1 (%2)</translation>
    </message>
    <message>
        <source>Spread of the particles after each iteration on this frame. The filter has converged where the curve levels off.</source>
        <translation>Streuung der Partikel nach jeder Iteration an diesem Bild. Wo die Kurve flach wird, ist der Filter konvergiert.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>cannot be written</source>
        <translation>kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>does not fit the rest</source>
        <translation>passt nicht zum Übrigen</translation>
    </message>
    <message>
        <source>ended before its announced end</source>
        <translation>endete vor dem angekündigten Ende</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>not a usable value</source>
        <translation>kein brauchbarer Wert</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>auf Wunsch abgebrochen</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>die Kamera lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the camera stopped delivering images</source>
        <translation>die Kamera liefert keine Bilder mehr</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>die Datei existiert nicht</translation>
    </message>
    <message>
        <source>the observations do not settle it</source>
        <translation>die Beobachtungen legen es nicht fest</translation>
    </message>
    <message>
        <source>the text cannot be understood</source>
        <translation>der Text ist nicht verständlich</translation>
    </message>
    <message>
        <source>there is nothing of this name</source>
        <translation>es gibt nichts mit diesem Namen</translation>
    </message>
    <message>
        <source>this key is missing</source>
        <translation>dieser Schlüssel fehlt</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>unbekannter Schlüssel</translation>
    </message>
    <message>
        <source>wrong type of value</source>
        <translation>falsche Art von Wert</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>Barrera et al. 2005, figure 3: the particles projected into both cameras while the cloud finds the ball.</source>
        <translation>Barrera et al. 2005, Abbildung 3: die Partikel in beiden Kamerabildern, während die Wolke den Ball findet.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 4: the same cloud from above.</source>
        <translation>Barrera et al. 2005, Abbildung 4: dieselbe Wolke von oben.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 6: the object jumps 2 m at iteration 30.</source>
        <translation>Barrera et al. 2005, Abbildung 6: Das Objekt springt bei Iteration 30 um 2 m.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 7: the same for motion sigmas from 0.001 to 0.3 m, as an image.</source>
        <translation>Barrera et al. 2005, Abbildung 7: dasselbe für Bewegungs-Sigmas von 0,001 bis 0,3 m, als Bild.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 8: the cloud at six instants, with a small and a large motion sigma.</source>
        <translation>Barrera et al. 2005, Abbildung 8: die Wolke in sechs Momenten, mit kleinem und großem Bewegungs-Sigma.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: start volume against the share of runs that converge, and starts beyond the ball.</source>
        <translation>Barrera et al. 2005, Abschnitt III-B: Startvolumen gegen den Anteil der Läufe, die konvergieren, und Starts hinter dem Ball.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: with one camera the cloud moves away from it.</source>
        <translation>Barrera et al. 2005, Abschnitt III-B: Mit einer Kamera entfernt sich die Wolke von ihr.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 5: where one camera alone finds the color, and why the cloud moves away from it.</source>
        <translation>Barrera et al. 2005, Abbildung 5: wo eine Kamera allein die Farbe findet und warum sich die Wolke von ihr entfernt.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009, figures 1 and 3: what moves in the images of a camera, in pieces, and how likely that makes a person at each pixel.</source>
        <translation>Mohedano et al. 2009, Abbildungen 1 und 3: was sich in den Bildern einer Kamera bewegt, in Stücken, und für wie wahrscheinlich das eine Person an jedem Pixel macht.</translation>
    </message>
    <message>
        <source>Drift along the optical axis</source>
        <translation>Abdrift entlang der optischen Achse</translation>
    </message>
    <message>
        <source>Error after a jump</source>
        <translation>Fehler nach einem Sprung</translation>
    </message>
    <message>
        <source>Error over iteration and motion sigma</source>
        <translation>Fehler über Iteration und Bewegungs-Sigma</translation>
    </message>
    <message>
        <source>Particles from above</source>
        <translation>Partikel von oben</translation>
    </message>
    <message>
        <source>Particles in both images</source>
        <translation>Partikel in beiden Bildern</translation>
    </message>
    <message>
        <source>The cloud on its way</source>
        <translation>Die Wolke unterwegs</translation>
    </message>
    <message>
        <source>Motion masks and motion likelihood</source>
        <translation>Bewegungsmasken und Bewegungswahrscheinlichkeit</translation>
    </message>
    <message>
        <source>The cone of one camera</source>
        <translation>Der Kegel einer Kamera</translation>
    </message>
    <message>
        <source>Where the cloud may start</source>
        <translation>Wo die Wolke beginnen darf</translation>
    </message>
    <message>
        <source>Boxes: error, success and precision</source>
        <translation>Rahmen: Fehler, Erfolg und Genauigkeit</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people come and go; how long an estimate belongs to nobody, and how long a person has no estimate.</source>
        <translation>Mohedano u. a. 2009: Personen kommen und gehen; wie lange eine Schätzung zu niemandem gehört und wie lange eine Person keine Schätzung hat.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet and walk on; motion alone may confuse them, color keeps them apart when their clothes differ.</source>
        <translation>Mohedano u. a. 2009: Zwei Personen begegnen sich und gehen weiter; die Bewegung allein kann sie verwechseln, die Farbe hält sie auseinander, wenn ihre Kleidung verschieden ist.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet, stay and go back where they came from.</source>
        <translation>Mohedano u. a. 2009: Zwei Personen treffen sich, bleiben stehen und gehen zurück, woher sie kamen.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people walk close to each other.</source>
        <translation>Mohedano u. a. 2009: Zwei Personen gehen dicht nebeneinander.</translation>
    </message>
    <message>
        <source>People side by side</source>
        <translation>Personen nebeneinander</translation>
    </message>
    <message>
        <source>People who cross</source>
        <translation>Personen, die sich kreuzen</translation>
    </message>
    <message>
        <source>People who enter and leave</source>
        <translation>Personen, die kommen und gehen</translation>
    </message>
    <message>
        <source>People who meet and turn</source>
        <translation>Personen, die sich treffen und umkehren</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009, section 4: 100 and 300 particles, method histogram and four trackers of OpenCV on the same clips.</source>
        <translation>Sugandi u. a. 2009, Abschnitt 4: 100 und 300 Partikel, das Verfahren histogram und vier Verfolger von OpenCV auf denselben Filmen.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people far from each other, the easy case, in which no method may mix them up.</source>
        <translation>Mohedano u. a. 2009: zwei Personen, weit voneinander entfernt: der leichte Fall, in dem kein Verfahren sie verwechseln darf.</translation>
    </message>
    <message>
        <source>People who stay apart</source>
        <translation>Personen, die Abstand halten</translation>
    </message>
    <message>
        <source>Barrera et al. 2005: a ball in space</source>
        <translation>Barrera et al. 2005: ein Ball im Raum</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009: boxes in one camera</source>
        <translation>Sugandi u. a. 2009: Rahmen in einer Kamera</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people</source>
        <translation>Mohedano u. a. 2009: Personen</translation>
    </message>
    <message>
        <source>More scenes of people</source>
        <translation>Weitere Szenen mit Personen</translation>
    </message>
    <message>
        <source>People of different heights</source>
        <translation>Verschieden große Personen</translation>
    </message>
    <message>
        <source>A child of 0.9 to 1.3 m, one person of 1.3 to 1.6 m and one of 1.88 to 2 m walk about.</source>
        <translation>Ein Kind von 0,9 bis 1,3 m, eine Person von 1,3 bis 1,6 m und eine von 1,88 bis 2 m gehen umher.</translation>
    </message>
    <message>
        <source>People who sit and crouch</source>
        <translation>Personen, die sitzen und hocken</translation>
    </message>
    <message>
        <source>One person sits down on a stool and rises, one crouches and rises, and one walks by.</source>
        <translation>Eine Person setzt sich auf einen Hocker und steht auf, eine hockt sich hin und steht auf, und eine geht vorbei.</translation>
    </message>
    <message>
        <source>People who carry things</source>
        <translation>Personen, die etwas tragen</translation>
    </message>
    <message>
        <source>Two people walk past each other, one with a box before the chest, one with a bag.</source>
        <translation>Zwei Personen gehen aneinander vorbei, eine mit einer Kiste vor der Brust, eine mit einer Tasche.</translation>
    </message>
    <message>
        <source>A crowd</source>
        <translation>Ein Gedränge</translation>
    </message>
    <message>
        <source>Five to eight people mill about for 12 s; their paths may touch and cross.</source>
        <translation>Fünf bis acht Personen laufen 12 s lang durcheinander; ihre Wege können sich berühren und kreuzen.</translation>
    </message>
    <message>
        <source>People seen by two cameras</source>
        <translation>Personen, die zwei Kameras sehen</translation>
    </message>
    <message>
        <source>Two people walk past each other, seen by only two of the four cameras.</source>
        <translation>Zwei Personen gehen aneinander vorbei; nur zwei der vier Kameras sehen sie.</translation>
    </message>
    <message>
        <source>People who come close</source>
        <translation>Personen, die sich sehr nahe kommen</translation>
    </message>
    <message>
        <source>Two people come within 0.15 to 0.28 m of each other, stand there, and go back.</source>
        <translation>Zwei Personen nähern sich auf 0,15 bis 0,28 m, bleiben stehen und gehen zurück.</translation>
    </message>
    <message>
        <source>Furniture that moves</source>
        <translation>Möbel, die sich bewegen</translation>
    </message>
    <message>
        <source>A cabinet and a stool are moved after the cameras have learned the background.</source>
        <translation>Ein Schrank und ein Hocker werden verschoben, nachdem die Kameras den Hintergrund gelernt haben.</translation>
    </message>
    <message>
        <source>Clothes like the room</source>
        <translation>Kleidung wie der Raum</translation>
    </message>
    <message>
        <source>Two people in clothes of the colors of walls, furniture and floor walk past each other.</source>
        <translation>Zwei Personen in Kleidung in den Farben von Wänden, Möbeln und Boden gehen aneinander vorbei.</translation>
    </message>
    <message>
        <source>Patterned clothes</source>
        <translation>Gemusterte Kleidung</translation>
    </message>
    <message>
        <source>Two people in striped, checked or blotched shirts walk past each other.</source>
        <translation>Zwei Personen in gestreiften, karierten oder gefleckten Hemden gehen aneinander vorbei.</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>CSV, one row per target and time</source>
        <translation>CSV, eine Zeile je Ziel und Zeitpunkt</translation>
    </message>
    <message>
        <source>CSV, one row per time (spreadsheets)</source>
        <translation>CSV, eine Zeile je Zeitpunkt (Tabellen)</translation>
    </message>
    <message>
        <source>TUM (evo)</source>
        <translation>TUM (evo)</translation>
    </message>
    <message>
        <source>TRC (OpenSim)</source>
        <translation>TRC (OpenSim)</translation>
    </message>
    <message>
        <source>C3D (motion capture)</source>
        <translation>C3D (Bewegungserfassung)</translation>
    </message>
    <message>
        <source>NPZ (NumPy)</source>
        <translation>NPZ (NumPy)</translation>
    </message>
    <message>
        <source>VTP (ParaView, paths)</source>
        <translation>VTP (ParaView, Bahnen)</translation>
    </message>
    <message>
        <source>PVD (ParaView, over time)</source>
        <translation>PVD (ParaView, über die Zeit)</translation>
    </message>
    <message>
        <source>JSON lines</source>
        <translation>JSON-Zeilen</translation>
    </message>
    <message>
        <source>Z points up, axes as in the project</source>
        <translation>Z zeigt nach oben, Achsen wie im Projekt</translation>
    </message>
    <message>
        <source>Y points up: x, y, z are y, z, x of the project</source>
        <translation>Y zeigt nach oben: x, y, z sind y, z, x des Projekts</translation>
    </message>
    <message>
        <source>Lengths in %1, times in s, covariances in %1². %2.</source>
        <translation>Längen in %1, Zeiten in s, Kovarianzen in %1². %2.</translation>
    </message>
    <message>
        <source>no gaps</source>
        <translation>keine Lücken</translation>
    </message>
    <message>
        <source>%1 places unknown</source>
        <translation>%1 Orte unbekannt</translation>
    </message>
    <message>
        <source>Targets: %1, rows: %2 at %3 per second, %4.</source>
        <translation>Ziele: %1, Zeilen: %2 bei %3 pro Sekunde, %4.</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Wrote the figure %1.</source>
        <translation>Die Abbildung %1 wurde geschrieben.</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2 files; the last is %3.</source>
        <translation>%1 Zeilen in %2 Dateien exportiert; die letzte ist %3.</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2.</source>
        <translation>%1 Zeilen nach %2 exportiert.</translation>
    </message>
</context>
<context>
    <name>GlContext</name>
    <message>
        <source>no OpenGL context can be made on this display</source>
        <translation>auf dieser Anzeige lässt sich kein OpenGL-Kontext anlegen</translation>
    </message>
    <message>
        <source>the OpenGL context cannot be used</source>
        <translation>der OpenGL-Kontext ist nicht benutzbar</translation>
    </message>
    <message>
        <source>OpenGL 3.2 is needed</source>
        <translation>OpenGL 3.2 wird benötigt</translation>
    </message>
</context>
<context>
    <name>HoldState</name>
    <message>
        <source>● held</source>
        <translation>● gehalten</translation>
    </message>
    <message>
        <source>○ searching</source>
        <translation>○ sucht</translation>
    </message>
    <message>
        <source>▲ lost</source>
        <translation>▲ verloren</translation>
    </message>
    <message>
        <source>✕ missing</source>
        <translation>✕ fehlt</translation>
    </message>
    <message>
        <source>– no images</source>
        <translation>– keine Bilder</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>Noch kein Ziel</translation>
    </message>
    <message>
        <source>– not tracked</source>
        <translation>– nicht verfolgt</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ verdeckt</translation>
    </message>
    <message>
        <source>– no box</source>
        <translation>– kein Rahmen</translation>
    </message>
    <message>
        <source>◔ learning the room</source>
        <translation>◔ lernt den Raum</translation>
    </message>
    <message>
        <source>◌ nobody there</source>
        <translation>◌ niemand da</translation>
    </message>
    <message>
        <source>– not there</source>
        <translation>– nicht da</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ mehrdeutig</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>blank: none</source>
        <translation>leer: keine</translation>
    </message>
    <message>
        <source>blank: fewer than two cameras</source>
        <translation>leer: weniger als zwei Kameras</translation>
    </message>
    <message>
        <source>Cameras that see it</source>
        <translation>Kameras, die es sehen</translation>
    </message>
    <message>
        <source>Expected error (1 σ)</source>
        <translation>Erwarteter Fehler (1 σ)</translation>
    </message>
</context>
<context>
    <name>MapOverlay</name>
    <message>
        <source>Cameras that see it: %1</source>
        <translation>Kameras, die es sehen: %1</translation>
    </message>
    <message>
        <source>±%1 (1 σ); cameras that see it: %2</source>
        <translation>±%1 (1 σ); Kameras, die es sehen: %2</translation>
    </message>
</context>
<context>
    <name>Method</name>
    <message>
        <source>A box in one video</source>
        <translation>Ein Rahmen in einem Video</translation>
    </message>
    <message>
        <source>A particle filter on color histograms</source>
        <translation>Ein Partikelfilter auf Farbhistogrammen</translation>
    </message>
    <message>
        <source>A particle filter on positions</source>
        <translation>Ein Partikelfilter auf Positionen</translation>
    </message>
    <message>
        <source>A plain particle filter on color</source>
        <translation>Ein einfacher Partikelfilter auf Farbe</translation>
    </message>
    <message>
        <source>Anything colored, in 3D</source>
        <translation>Alles Farbige, in 3D</translation>
    </message>
    <message>
        <source>Anything you draw a box around</source>
        <translation>Alles, worum Sie einen Rahmen ziehen</translation>
    </message>
    <message>
        <source>Balls, hands, anything colored</source>
        <translation>Bälle, Hände, alles Farbige</translation>
    </message>
    <message>
        <source>Follows its colors and its size, and finds it again after it was hidden.</source>
        <translation>Folgt seinen Farben und seiner Größe und findet es wieder, wenn es verdeckt war.</translation>
    </message>
    <message>
        <source>For comparison: confuses people who come close.</source>
        <translation>Zum Vergleich: verwechselt Personen, die sich nahe kommen.</translation>
    </message>
    <message>
        <source>For comparison: tells people apart by different clothes.</source>
        <translation>Zum Vergleich: unterscheidet Personen an verschiedener Kleidung.</translation>
    </message>
    <message>
        <source>For teaching: follows a box in one video.</source>
        <translation>Für die Lehre: folgt einem Rahmen in einem Video.</translation>
    </message>
    <message>
        <source>For teaching: shows how a particle filter works.</source>
        <translation>Für die Lehre: zeigt, wie ein Partikelfilter arbeitet.</translation>
    </message>
    <message>
        <source>For teaching: shows how particles follow measurements.</source>
        <translation>Für die Lehre: zeigt, wie Partikel Messungen folgen.</translation>
    </message>
    <message>
        <source>From papers, for teaching and comparison</source>
        <translation>Aus Artikeln, für Lehre und Vergleich</translation>
    </message>
    <message>
        <source>People by motion alone</source>
        <translation>Personen nur nach Bewegung</translation>
    </message>
    <message>
        <source>People by motion and color</source>
        <translation>Personen nach Bewegung und Farbe</translation>
    </message>
    <message>
        <source>People in a room</source>
        <translation>Personen in einem Raum</translation>
    </message>
    <message>
        <source>People who walk and meet</source>
        <translation>Personen, die gehen und sich treffen</translation>
    </message>
    <message>
        <source>Positions on the floor of several people, also in similar clothes.</source>
        <translation>Positionen mehrerer Personen auf dem Boden, auch in ähnlicher Kleidung.</translation>
    </message>
    <message>
        <source>The most accurate: decides by itself between a ball and any other shape.</source>
        <translation>Das genaueste: entscheidet selbst zwischen einem Ball und jeder anderen Form.</translation>
    </message>
</context>
<context>
    <name>MethodObstacle</name>
    <message>
        <source>Needs calibrated cameras.</source>
        <translation>Braucht kalibrierte Kameras.</translation>
    </message>
    <message>
        <source>Needs at least two cameras.</source>
        <translation>Braucht mindestens zwei Kameras.</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Half the x size of the box around the start in which particles start evenly spread; 0 starts them all at the same x.</source>
        <translation>Halbe x-Ausdehnung des Quaders um den Start, in dem die Partikel gleichmäßig verteilt beginnen; bei 0 beginnen alle beim selben x.</translation>
    </message>
    <message>
        <source>Half the y size of the box around the start in which particles start evenly spread; 0 starts them all at the same y.</source>
        <translation>Halbe y-Ausdehnung des Quaders um den Start, in dem die Partikel gleichmäßig verteilt beginnen; bei 0 beginnen alle beim selben y.</translation>
    </message>
    <message>
        <source>Half the z size of the box around the start in which particles start evenly spread; 0 starts them all at the same z.</source>
        <translation>Halbe z-Ausdehnung des Quaders um den Start, in dem die Partikel gleichmäßig verteilt beginnen; bei 0 beginnen alle beim selben z.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis in one iteration: larger follows faster objects and spreads wider.</source>
        <translation>Wie weit sich Partikel in einer Iteration zufällig entlang jeder Achse bewegen: Größere Werte folgen schnelleren Objekten und streuen weiter.</translation>
    </message>
    <message>
        <source>How many filter iterations run on each frame.</source>
        <translation>Wie viele Filteriterationen auf jedem Bild laufen.</translation>
    </message>
    <message>
        <source>How many particles the filter uses: more follow more surely and cost more time.</source>
        <translation>Wie viele Partikel der Filter benutzt: Mehr folgen sicherer und kosten mehr Zeit.</translation>
    </message>
    <message>
        <source>Iterations per frame</source>
        <translation>Iterationen je Bild</translation>
    </message>
    <message>
        <source>Motion sigma</source>
        <translation>Bewegungs-Sigma</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partikel</translation>
    </message>
    <message>
        <source>Start half-size x</source>
        <translation>Start: halbe Größe x</translation>
    </message>
    <message>
        <source>Start half-size y</source>
        <translation>Start: halbe Größe y</translation>
    </message>
    <message>
        <source>Start half-size z</source>
        <translation>Start: halbe Größe z</translation>
    </message>
    <message>
        <source>Start x</source>
        <translation>Start x</translation>
    </message>
    <message>
        <source>Start y</source>
        <translation>Start y</translation>
    </message>
    <message>
        <source>Start z</source>
        <translation>Start z</translation>
    </message>
    <message>
        <source>World x of the place where all particles start.</source>
        <translation>Weltkoordinate x des Ortes, an dem alle Partikel beginnen.</translation>
    </message>
    <message>
        <source>World y of the place where all particles start.</source>
        <translation>Weltkoordinate y des Ortes, an dem alle Partikel beginnen.</translation>
    </message>
    <message>
        <source>World z of the place where all particles start.</source>
        <translation>Weltkoordinate z des Ortes, an dem alle Partikel beginnen.</translation>
    </message>
    <message>
        <source>Acceleration sigma</source>
        <translation>Beschleunigungs-Sigma</translation>
    </message>
    <message>
        <source>Edge of the room in which a target may appear: larger asks for more evidence before a target is believed.</source>
        <translation>Kantenlänge des Raums, in dem ein Ziel auftauchen kann: Größere Werte verlangen mehr Belege, bevor an ein Ziel geglaubt wird.</translation>
    </message>
    <message>
        <source>Fewest particles</source>
        <translation>Mindestzahl der Partikel</translation>
    </message>
    <message>
        <source>How far the particles may be from the distribution they stand for (Kullback-Leibler distance): smaller takes more particles where they disagree; 0 always takes all of them.</source>
        <translation>Wie weit die Partikel von der Verteilung abweichen dürfen, für die sie stehen (Kullback-Leibler-Abstand): Kleinere Werte nehmen mehr Partikel, wo diese uneins sind; 0 nimmt immer alle.</translation>
    </message>
    <message>
        <source>How long a target that no camera can judge is believed to be still there.</source>
        <translation>Wie lange ein Ziel, das keine Kamera beurteilen kann, noch als vorhanden gilt.</translation>
    </message>
    <message>
        <source>How many particles each target uses at least, when they all agree.</source>
        <translation>Wie viele Partikel jedes Ziel mindestens benutzt, wenn alle einig sind.</translation>
    </message>
    <message>
        <source>How many particles each target uses at most.</source>
        <translation>Wie viele Partikel jedes Ziel höchstens benutzt.</translation>
    </message>
    <message>
        <source>How strongly targets speed up, slow down and turn: larger follows abrupt motion, smaller bridges gaps better.</source>
        <translation>Wie stark Ziele beschleunigen, bremsen und abbiegen: Größere Werte folgen abrupten Bewegungen, kleinere überbrücken Lücken besser.</translation>
    </message>
    <message>
        <source>Sampling error</source>
        <translation>Stichprobenfehler</translation>
    </message>
    <message>
        <source>Search size</source>
        <translation>Suchraumgröße</translation>
    </message>
    <message>
        <source>Survival time</source>
        <translation>Überlebenszeit</translation>
    </message>
    <message>
        <source>Time budget</source>
        <translation>Zeitbudget</translation>
    </message>
    <message>
        <source>How long one iteration may take: fewer particles are used, and searches are spread over several frames, to keep to it. 0 sets no limit; with a limit a run depends on the speed of the machine and cannot be repeated bit by bit.</source>
        <translation>Wie lange eine Iteration dauern darf: Um das einzuhalten, werden weniger Partikel benutzt und Suchen über mehrere Bilder verteilt. 0 setzt keine Grenze; mit einer Grenze hängt ein Lauf von der Geschwindigkeit des Rechners ab und lässt sich nicht Bit für Bit wiederholen.</translation>
    </message>
    <message>
        <source>Color adaptation</source>
        <translation>Farbanpassung</translation>
    </message>
    <message>
        <source>How fast a target&apos;s color range follows slow changes of light, as a time constant; only while the target is surely there, and in each camera by itself. 0 keeps the range as it is; 2 is a good value in a room with daylight.</source>
        <translation>Wie schnell der Farbbereich eines Ziels langsamen Änderungen des Lichts folgt, als Zeitkonstante; nur während das Ziel sicher da ist, und in jeder Kamera für sich. 0 lässt den Bereich, wie er ist; 2 ist ein guter Wert in einem Raum mit Tageslicht.</translation>
    </message>
    <message>
        <source>How far off a measured position is taken to be along each axis: larger trusts the particles more, smaller the measurement.</source>
        <translation>Wie ungenau eine gemessene Position je Achse angenommen wird: größer vertraut mehr den Partikeln, kleiner der Messung.</translation>
    </message>
    <message>
        <source>Observation sigma</source>
        <translation>Beobachtungs-Sigma</translation>
    </message>
    <message>
        <source>Adaptation</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Aspect sigma</source>
        <translation>Seitenverhältnis-Sigma</translation>
    </message>
    <message>
        <source>Hidden below</source>
        <translation>Verdeckt unterhalb</translation>
    </message>
    <message>
        <source>How different from the reference the colors may be (Bhattacharyya distance): smaller trusts the best particles more.</source>
        <translation>Wie verschieden von der Vorlage die Farben sein dürfen (Bhattacharyya-Abstand): Kleinere Werte trauen den besten Partikeln mehr.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis from image to image, beside going on as before, in sizes of the target.</source>
        <translation>Wie weit sich Partikel von Bild zu Bild entlang jeder Achse zufällig bewegen, außer dass sie weitergehen wie zuvor, in Größen des Ziels.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis from image to image, beside going on as before: larger follows sudden motion and spreads wider.</source>
        <translation>Wie weit sich Partikel von Bild zu Bild entlang jeder Achse zufällig bewegen, außer dass sie weitergehen wie zuvor: Größere Werte folgen plötzlichen Bewegungen und streuen weiter.</translation>
    </message>
    <message>
        <source>How far the target may be from where it was expected, in sizes of the target, before that counts strongly against a place.</source>
        <translation>Wie weit das Ziel vom erwarteten Ort entfernt sein darf, in Größen des Ziels, bevor das stark gegen einen Ort spricht.</translation>
    </message>
    <message>
        <source>How much better a place with more of the target&apos;s colors is held to be.</source>
        <translation>Wie viel besser ein Ort mit mehr von den Farben des Ziels gilt.</translation>
    </message>
    <message>
        <source>How much the proportion of width to height may change from image to image (logarithm); 0 keeps it as it was given.</source>
        <translation>Wie sehr sich das Verhältnis von Breite zu Höhe von Bild zu Bild ändern darf (Logarithmus); 0 lässt es, wie es gegeben wurde.</translation>
    </message>
    <message>
        <source>How much the size of the box may change from image to image (logarithm); 0 keeps it as it was given.</source>
        <translation>Wie sehr sich die Größe des Rahmens von Bild zu Bild ändern darf (Logarithmus); 0 lässt sie, wie sie gegeben wurde.</translation>
    </message>
    <message>
        <source>Jump reach</source>
        <translation>Reichweite der Sprünge</translation>
    </message>
    <message>
        <source>Jump share</source>
        <translation>Anteil der Sprünge</translation>
    </message>
    <message>
        <source>Likelihood sigma</source>
        <translation>Likelihood-Sigma</translation>
    </message>
    <message>
        <source>Position sigma</source>
        <translation>Orts-Sigma</translation>
    </message>
    <message>
        <source>Scale sigma</source>
        <translation>Größen-Sigma</translation>
    </message>
    <message>
        <source>Share by which the reference colors follow those of the box from image to image; 0 keeps those of the first image.</source>
        <translation>Anteil, um den die Vorlagefarben von Bild zu Bild denen des Rahmens folgen; 0 behält die des ersten Bildes.</translation>
    </message>
    <message>
        <source>Share of the particles that are tried at other places with the target&apos;s colors.</source>
        <translation>Anteil der Partikel, die an anderen Orten mit den Farben des Ziels versucht werden.</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>The target counts as hidden, and is held, where less than this share of its usual colors is found.</source>
        <translation>Das Ziel gilt als verdeckt und wird gehalten, wo weniger als dieser Anteil seiner üblichen Farben gefunden wird.</translation>
    </message>
    <message>
        <source>1: who is seen by several cameras becomes a person; 0: only people put there by hand.</source>
        <translation>1: Wer von mehreren Kameras gesehen wird, wird eine Person; 0: nur von Hand gesetzte Personen.</translation>
    </message>
    <message>
        <source>After how long something new that stays counts as background.</source>
        <translation>Nach welcher Zeit etwas Neues, das bleibt, als Hintergrund gilt.</translation>
    </message>
    <message>
        <source>Area half size x</source>
        <translation>Fläche: halbe Größe x</translation>
    </message>
    <message>
        <source>Area half size y</source>
        <translation>Fläche: halbe Größe y</translation>
    </message>
    <message>
        <source>Area x</source>
        <translation>Fläche x</translation>
    </message>
    <message>
        <source>Area y</source>
        <translation>Fläche y</translation>
    </message>
    <message>
        <source>Background memory</source>
        <translation>Hintergrundgedächtnis</translation>
    </message>
    <message>
        <source>Background model</source>
        <translation>Hintergrundmodell</translation>
    </message>
    <message>
        <source>Birth time</source>
        <translation>Erscheinungszeit</translation>
    </message>
    <message>
        <source>Births</source>
        <translation>Neue Personen</translation>
    </message>
    <message>
        <source>Body points</source>
        <translation>Körperpunkte</translation>
    </message>
    <message>
        <source>Color noise</source>
        <translation>Farbrauschen</translation>
    </message>
    <message>
        <source>Color weight</source>
        <translation>Farbgewicht</translation>
    </message>
    <message>
        <source>Darkest shadow</source>
        <translation>Dunkelster Schatten</translation>
    </message>
    <message>
        <source>Evidence per camera</source>
        <translation>Belege je Kamera</translation>
    </message>
    <message>
        <source>Floor z</source>
        <translation>Boden z</translation>
    </message>
    <message>
        <source>Half the size of the floor that is watched; who crosses its border has left.</source>
        <translation>Halbe Größe der beobachteten Bodenfläche; wer ihren Rand überschreitet, ist gegangen.</translation>
    </message>
    <message>
        <source>Height of a person whose own is not known yet.</source>
        <translation>Größe einer Person, deren eigene noch nicht bekannt ist.</translation>
    </message>
    <message>
        <source>Height of the floor in the world frame.</source>
        <translation>Höhe des Bodens im Weltsystem.</translation>
    </message>
    <message>
        <source>How long a person whom no two cameras see is believed to be still there.</source>
        <translation>Wie lange eine Person, die keine zwei Kameras sehen, noch als vorhanden gilt.</translation>
    </message>
    <message>
        <source>How long foreground that nobody explains must stay together to become a person.</source>
        <translation>Wie lange Vordergrund, den niemand erklärt, zusammenbleiben muss, um eine Person zu werden.</translation>
    </message>
    <message>
        <source>How long the cameras only learn what they usually show, at first; nobody should be there.</source>
        <translation>Wie lange die Kameras anfangs nur lernen, was sie gewöhnlich zeigen; niemand sollte dort sein.</translation>
    </message>
    <message>
        <source>How many particles each person has.</source>
        <translation>Wie viele Partikel jede Person hat.</translation>
    </message>
    <message>
        <source>How many points stand for the volume of each person.</source>
        <translation>Wie viele Punkte für das Volumen jeder Person stehen.</translation>
    </message>
    <message>
        <source>How moving regions are found: 0 one Gaussian per pixel (fast), 1 OpenCV&apos;s MOG2, 2 OpenCV&apos;s KNN.</source>
        <translation>Wie bewegte Bereiche gefunden werden: 0 eine Normalverteilung je Pixel (schnell), 1 MOG2 von OpenCV, 2 KNN von OpenCV.</translation>
    </message>
    <message>
        <source>How much a camera that sees a whole person says: larger trusts the masks more.</source>
        <translation>Wie viel eine Kamera sagt, die eine ganze Person sieht: Größere Werte vertrauen den Masken mehr.</translation>
    </message>
    <message>
        <source>How much the colors of clothes count beside the masks when people are near each other.</source>
        <translation>Wie viel die Farben der Kleidung neben den Masken zählen, wenn Personen sich nahe sind.</translation>
    </message>
    <message>
        <source>How near the middles of two people can come.</source>
        <translation>Wie nahe sich die Mitten zweier Personen kommen können.</translation>
    </message>
    <message>
        <source>How strongly people speed up, slow down and turn.</source>
        <translation>Wie stark Personen beschleunigen, bremsen und abbiegen.</translation>
    </message>
    <message>
        <source>Hue floor</source>
        <translation>Farbton-Mindestwert</translation>
    </message>
    <message>
        <source>Hue sigma</source>
        <translation>Farbton-Sigma</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>Bildbreite</translation>
    </message>
    <message>
        <source>Images are reduced to at most this width before anything else; 0 keeps them as they are.</source>
        <translation>Bilder werden zuerst auf höchstens diese Breite verkleinert; 0 lässt sie, wie sie sind.</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>Lernzeit</translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation>Mindestabstand</translation>
    </message>
    <message>
        <source>Least likelihood of a hue (the paper&apos;s h_B): something else may be seen.</source>
        <translation>Kleinste Likelihood eines Farbtons (h_B im Artikel): Es kann etwas anderes zu sehen sein.</translation>
    </message>
    <message>
        <source>Least likelihood of a saturation (the paper&apos;s s_B).</source>
        <translation>Kleinste Likelihood einer Sättigung (s_B im Artikel).</translation>
    </message>
    <message>
        <source>Least likelihood where a camera sees no motion (the paper&apos;s p_B: 0.2).</source>
        <translation>Kleinste Likelihood, wo eine Kamera keine Bewegung sieht (p_B im Artikel: 0,2).</translation>
    </message>
    <message>
        <source>Mask smoothing</source>
        <translation>Maskenglättung</translation>
    </message>
    <message>
        <source>Middle of the floor that is watched.</source>
        <translation>Mitte der beobachteten Bodenfläche.</translation>
    </message>
    <message>
        <source>Motion floor</source>
        <translation>Bewegungs-Mindestwert</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>Ortsrauschen</translation>
    </message>
    <message>
        <source>Saturation floor</source>
        <translation>Sättigungs-Mindestwert</translation>
    </message>
    <message>
        <source>Saturation sigma</source>
        <translation>Sättigungs-Sigma</translation>
    </message>
    <message>
        <source>Sigma of the Gaussian that smooths the motion masks (the paper: 4 px).</source>
        <translation>Sigma der Gauß-Glättung der Bewegungsmasken (im Artikel: 4 px).</translation>
    </message>
    <message>
        <source>Standard deviation of a measured hue, in [0, 1].</source>
        <translation>Standardabweichung eines gemessenen Farbtons, in [0, 1].</translation>
    </message>
    <message>
        <source>Standard deviation of a measured saturation, in [0, 1].</source>
        <translation>Standardabweichung einer gemessenen Sättigung, in [0, 1].</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each component of the velocity, per frame.</source>
        <translation>Standardabweichung des Rauschens auf jeder Komponente der Geschwindigkeit, je Bild.</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each coordinate, per frame.</source>
        <translation>Standardabweichung des Rauschens auf jeder Koordinate, je Bild.</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on hue and saturation, per frame.</source>
        <translation>Standardabweichung des Rauschens auf Farbton und Sättigung, je Bild.</translation>
    </message>
    <message>
        <source>Usual height</source>
        <translation>Übliche Größe</translation>
    </message>
    <message>
        <source>Velocity noise</source>
        <translation>Geschwindigkeitsrauschen</translation>
    </message>
    <message>
        <source>What is darker than usual by no more than this factor, in the same tint, is a shadow.</source>
        <translation>Was höchstens um diesen Faktor dunkler ist als sonst, bei gleichem Farbton, ist ein Schatten.</translation>
    </message>
    <message>
        <source>Calibration error</source>
        <translation>Fehler der Kalibrierung</translation>
    </message>
    <message>
        <source>How far off the directions are in which the cameras see things. The stated uncertainty of a position includes it. 0.25 suits a calibration by hand.</source>
        <translation>Wie weit die Richtungen daneben liegen, in denen die Kameras etwas sehen. Die angegebene Unsicherheit einer Position enthält es. 0,25 passt zu einer Kalibrierung von Hand.</translation>
    </message>
    <message>
        <source>How far off the times of the images are. The stated uncertainty of a moving target includes it. 8 suits webcams.</source>
        <translation>Wie weit die Zeiten der Bilder daneben liegen. Die angegebene Unsicherheit eines bewegten Ziels enthält es. 8 passt zu Webcams.</translation>
    </message>
    <message>
        <source>Time error</source>
        <translation>Fehler der Zeit</translation>
    </message>
</context>
<context>
    <name>ParameterGroup</name>
    <message>
        <source>Area and people</source>
        <translation>Fläche und Personen</translation>
    </message>
    <message>
        <source>Essential</source>
        <translation>Wesentliches</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Für Fachleute</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Search and start</source>
        <translation>Suche und Start</translation>
    </message>
</context>
<context>
    <name>ParameterRow</name>
    <message>
        <source>%1
From %2 to %3%4; default %5%4.</source>
        <translation>%1
Von %2 bis %3%4; Vorgabe %5%4.</translation>
    </message>
    <message>
        <source>%1
From %2 to %3%4; what the cameras see unless you change it.</source>
        <translation>%1
Von %2 bis %3%4; was die Kameras sehen, solange Sie es nicht ändern.</translation>
    </message>
    <message>
        <source>Changed: the default is %1.</source>
        <translation>Geändert: Die Vorgabe ist %1.</translation>
    </message>
    <message>
        <source>Reset to %1 (Backspace on the slider)</source>
        <translation>Auf %1 zurücksetzen (Rücktaste auf dem Schieberegler)</translation>
    </message>
</context>
<context>
    <name>People</name>
    <message>
        <source>learning the empty room: %1 % · keep out of view</source>
        <translation>lernt den leeren Raum: %1 % · bitte nicht ins Bild treten</translation>
    </message>
    <message>
        <source>%1 % of the image moves: not looked at</source>
        <translation>%1 % des Bildes bewegen sich: nicht beachtet</translation>
    </message>
    <message>
        <source>learning: %1 %</source>
        <translation>lernt: %1 %</translation>
    </message>
</context>
<context>
    <name>PlotAxisStrip</name>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>Iteration</translation>
    </message>
</context>
<context>
    <name>PlotFigure</name>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>filter iteration</source>
        <translation>Filteriteration</translation>
    </message>
    <message>
        <source>Dewpoint plots</source>
        <translation>Dewpoint-Kurven</translation>
    </message>
</context>
<context>
    <name>PlotQuantity</name>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>title of a plot, unit of its axis</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>PlotReadout</name>
    <message>
        <source>truth</source>
        <translation>Wahrheit</translation>
    </message>
</context>
<context>
    <name>Quantity</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>no image</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>covered or moved</source>
        <translation>verdeckt oder bewegt</translation>
    </message>
    <message>
        <source>too dark</source>
        <translation>zu dunkel</translation>
    </message>
    <message>
        <source>out of view</source>
        <translation>außer Sicht</translation>
    </message>
    <message>
        <source>partly hidden</source>
        <translation>teilweise verdeckt</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verdeckt</translation>
    </message>
    <message>
        <source>at a look-alike</source>
        <translation>bei einem Doppelgänger</translation>
    </message>
    <message>
        <source>%1 beside a look-alike</source>
        <translation>%1 neben einem Doppelgänger</translation>
    </message>
    <message>
        <source>no color matches</source>
        <translation>keine passende Farbe</translation>
    </message>
    <message>
        <source>its color is %1 away</source>
        <translation>seine Farbe ist %1 entfernt</translation>
    </message>
    <message>
        <source>its color, but not its shape</source>
        <translation>seine Farbe, aber nicht seine Form</translation>
    </message>
    <message>
        <source>hidden here</source>
        <translation>hier verdeckt</translation>
    </message>
    <message>
        <source>not in this picture</source>
        <translation>nicht in diesem Bild</translation>
    </message>
</context>
<context>
    <name>RunPlots</name>
    <message>
        <source>all cameras</source>
        <translation>alle Kameras</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>Effektive Stichprobengröße</translation>
    </message>
    <message>
        <source>effective</source>
        <translation>effektiv</translation>
    </message>
    <message>
        <source>particles</source>
        <translation>Partikel</translation>
    </message>
    <message>
        <source>Log likelihood</source>
        <translation>Log-Likelihood</translation>
    </message>
    <message>
        <source>Existence</source>
        <translation>Existenz</translation>
    </message>
    <message>
        <source>Error against truth</source>
        <translation>Fehler gegen die Wahrheit</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Time per step</source>
        <translation>Zeit pro Schritt</translation>
    </message>
    <message>
        <source>one iteration</source>
        <translation>eine Iteration</translation>
    </message>
    <message>
        <source>Similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <source>to the reference</source>
        <translation>zur Vorlage</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Frame %1, %2</source>
        <translation>Bild %1, %2</translation>
    </message>
    <message>
        <source>not tracked</source>
        <translation>nicht verfolgt</translation>
    </message>
    <message>
        <source>✕ %1</source>
        <translation>✕ %1</translation>
    </message>
    <message>
        <source>history %1 of %2 MB</source>
        <translation>Verlauf %1 von %2 MB</translation>
    </message>
    <message>
        <source>, the last %1</source>
        <translation>, die letzten %1</translation>
    </message>
    <message>
        <source>tracking again: frame %1 of %2 to %3</source>
        <translation>verfolgt erneut: Bild %1 von %2 bis %3</translation>
    </message>
    <message>
        <source>✕ cameras</source>
        <translation>✕ Kameras</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>korrigiert</translation>
    </message>
    <message>
        <source>of earlier settings</source>
        <translation>von früheren Einstellungen</translation>
    </message>
    <message>
        <source>How well each target is held appears here when tracking runs.</source>
        <translation>Wie gut jedes Ziel gehalten wird, erscheint hier, sobald die Verfolgung läuft.</translation>
    </message>
</context>
<context>
    <name>TransportBar</name>
    <message>
        <source>Transport</source>
        <translation>Ablaufsteuerung</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Start</translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation>m/s²</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>sizes</source>
        <translation>Größen</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
</context>
<context>
    <name>WandSettings</name>
    <message>
        <source>touches the floor</source>
        <translation>berührt den Boden</translation>
    </message>
    <message>
        <source>is at the first end of the distance</source>
        <translation>ist am ersten Ende der Strecke</translation>
    </message>
    <message>
        <source>is at the second end of the distance</source>
        <translation>ist am zweiten Ende der Strecke</translation>
    </message>
    <message>
        <source>begins to fall</source>
        <translation>beginnt zu fallen</translation>
    </message>
    <message>
        <source>still falls</source>
        <translation>fällt noch</translation>
    </message>
    <message>
        <source>Two cameras or more must see the ball.</source>
        <translation>Mindestens zwei Kameras müssen den Ball sehen.</translation>
    </message>
    <message>
        <source>Learn the color of the ball first: press L and click it in an image.</source>
        <translation>Lernen Sie zuerst die Farbe des Balls: L drücken und ihn in einem Bild anklicken.</translation>
    </message>
    <message>
        <source>A stick has two balls of different colors: learn the second one (Shift+L).</source>
        <translation>Ein Stab hat zwei Bälle verschiedener Farbe: lernen Sie den zweiten (Umschalt+L).</translation>
    </message>
    <message>
        <source>The two ends of the stick are the same target: choose another.</source>
        <translation>Beide Enden des Stabs sind dasselbe Ziel: wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>The size is to come from a distance: take the moments at which the ball is at its two ends.</source>
        <translation>Die Größe soll von einer Strecke kommen: nehmen Sie die Augenblicke, in denen der Ball an ihren beiden Enden ist.</translation>
    </message>
    <message>
        <source>A fall needs two moments: one at which the ball begins to fall, and one at which it still falls.</source>
        <translation>Ein Fall braucht zwei Augenblicke: einen, in dem der Ball zu fallen beginnt, und einen, in dem er noch fällt.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AboutDialog</name>
    <message>
        <source>Show license</source>
        <translation>Lizenz zeigen</translation>
    </message>
    <message>
        <source>Hide license</source>
        <translation>Lizenz verbergen</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Über Dewpoint</translation>
    </message>
    <message>
        <source>Dewpoint %1</source>
        <translation>Dewpoint %1</translation>
    </message>
    <message>
        <source>Tracks colored objects in 3D, live, from ordinary cameras with particle filters.</source>
        <translation>Verfolgt farbige Objekte in 3D, live, aus gewöhnlichen Kameras mit Partikelfiltern.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later (GPL-3.0-or-later), without any warranty.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder später (GPL-3.0-or-later), ohne jede Gewährleistung.</translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation>So wird zitiert</translation>
    </message>
    <message>
        <source>Show the whole text of the license, or hide it</source>
        <translation>Den ganzen Text der Lizenz zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Copy citation</source>
        <translation>Zitat kopieren</translation>
    </message>
    <message>
        <source>Copy the line for your list of references</source>
        <translation>Die Zeile für Ihr Literaturverzeichnis kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddPersonTool</name>
    <message>
        <source>Click the person</source>
        <translation>Die Person anklicken</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter says that a person is there</source>
        <translation>Bild von %1: Pfeiltasten bewegen ein Kreuz, Eingabe sagt, dass dort eine Person ist</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackgroundImageTaker</name>
    <message>
        <source>“%1” is in this image: where it is now it would be taken for the room. Better show a moment without it.</source>
        <translation>„%1“ ist in diesem Bild: Wo es jetzt ist, würde es für den Raum gehalten. Besser einen Moment ohne es zeigen.</translation>
    </message>
    <message>
        <source>Use it all the same</source>
        <translation>Trotzdem verwenden</translation>
    </message>
    <message>
        <source>The camera was changed meanwhile: the image is kept as %1, but not used.</source>
        <translation>Die Kamera wurde inzwischen geändert: Das Bild ist als %1 aufgehoben, wird aber nicht verwendet.</translation>
    </message>
    <message>
        <source>Change empty room</source>
        <translation>Leeren Raum ändern</translation>
    </message>
    <message>
        <source>The image shown is now the empty room of %1; it is kept as %2.</source>
        <translation>Das gezeigte Bild ist jetzt der leere Raum von %1; es liegt in %2.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackwardTracker</name>
    <message>
        <source>Correct position</source>
        <translation>Position korrigieren</translation>
    </message>
    <message>
        <source>The target was followed back to frame %1; from there on it is tracked again.</source>
        <translation>Das Ziel wurde bis Bild %1 zurückverfolgt; ab dort wird es neu verfolgt.</translation>
    </message>
    <message>
        <source>Following the target back in time: frame %1.</source>
        <translation>Das Ziel wird rückwärts verfolgt: Bild %1.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BirdsEyeView</name>
    <message>
        <source>Bird&apos;s-eye view</source>
        <translation>Vogelperspektive</translation>
    </message>
    <message>
        <source>The room in 3D: cameras, particles, estimates and their tracks</source>
        <translation>Der Raum in 3D: Kameras, Partikel, Schätzungen und ihre Spuren</translation>
    </message>
    <message>
        <source>No 3D: %1</source>
        <translation>Kein 3D: %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrationPage</name>
    <message>
        <source>Board</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>What to find</source>
        <translation>Was zu finden ist</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Look for the board in the recording, and calibrate the cameras with it; one step that can be undone</source>
        <translation>Die Tafel in der Aufnahme suchen und die Kameras damit kalibrieren; ein Schritt, der sich zurücknehmen lässt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop; the former calibration is kept</source>
        <translation>Abbrechen; die bisherige Kalibrierung bleibt</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Take the calibration into the project; one step that can be undone</source>
        <translation>Die Kalibrierung ins Projekt übernehmen; ein Schritt, der sich zurücknehmen lässt</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Save a page with residuals, coverage and errors of all pictures, and open it</source>
        <translation>Eine Seite mit Residuen, Abdeckung und Fehlern aller Bilder speichern und öffnen</translation>
    </message>
    <message>
        <source>How far the calibration is</source>
        <translation>Wie weit die Kalibrierung ist</translation>
    </message>
    <message>
        <source>Show a printed board to the cameras: you are told what to show next, and it is taken when you hold it still.</source>
        <translation>Zeigen Sie den Kameras eine gedruckte Tafel: Sie erfahren, was als Nächstes zu zeigen ist; aufgenommen wird, wenn Sie still halten.</translation>
    </message>
    <message>
        <source>A recording in which a printed board is shown to the cameras, held still in many places, near and tilted, calibrates them.</source>
        <translation>Eine Aufnahme, in der eine gedruckte Tafel an vielen Orten still vor die Kameras gehalten wird, nah und geneigt, kalibriert sie.</translation>
    </message>
    <message>
        <source>Live cameras</source>
        <translation>Livekameras</translation>
    </message>
    <message>
        <source>This recording</source>
        <translation>Diese Aufnahme</translation>
    </message>
    <message>
        <source>✓ The cameras are calibrated (Ctrl+Z takes it back).</source>
        <translation>✓ Die Kameras sind kalibriert (Strg+Z nimmt es zurück).</translation>
    </message>
    <message>
        <source>Looking for the board: %p %</source>
        <translation>Suche die Tafel: %p %</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Berechne</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>Seite (*.html)</translation>
    </message>
    <message>
        <source>Use it anyway</source>
        <translation>Trotzdem verwenden</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrator</name>
    <message>
        <source>Stopped: the former calibration is kept.</source>
        <translation>Abgebrochen: die bisherige Kalibrierung bleibt.</translation>
    </message>
    <message>
        <source>The project has other cameras by now: calibrate again.</source>
        <translation>Das Projekt hat inzwischen andere Kameras: bitte neu kalibrieren.</translation>
    </message>
    <message>
        <source>Calibrate with a board</source>
        <translation>Mit einer Tafel kalibrieren</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardForm</name>
    <message>
        <source>Print the board</source>
        <translation>Tafel drucken</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>ChArUco (with markers)</source>
        <translation>ChArUco (mit Markern)</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>Art der Tafel</translation>
    </message>
    <message>
        <source>ChArUco boards may be partly hidden or outside the image; chessboards must be seen whole</source>
        <translation>ChArUco-Tafeln dürfen teilweise verdeckt oder außerhalb des Bildes sein; Schachbretter müssen ganz zu sehen sein</translation>
    </message>
    <message>
        <source>Squares across, down</source>
        <translation>Felder quer, hoch</translation>
    </message>
    <message>
        <source>Squares in a row</source>
        <translation>Felder in einer Zeile</translation>
    </message>
    <message>
        <source>All squares of a row, black and white</source>
        <translation>Alle Felder einer Zeile, schwarze und weiße</translation>
    </message>
    <message>
        <source>Squares in a column</source>
        <translation>Felder in einer Spalte</translation>
    </message>
    <message>
        <source>All squares of a column, black and white</source>
        <translation>Alle Felder einer Spalte, schwarze und weiße</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Feldes</translation>
    </message>
    <message>
        <source>Measured on the print: a long row with a ruler, divided by its squares</source>
        <translation>Am Ausdruck gemessen: eine lange Zeile mit dem Lineal, geteilt durch ihre Felder</translation>
    </message>
    <message>
        <source>Unit of the sizes</source>
        <translation>Einheit der Größen</translation>
    </message>
    <message>
        <source>Unit in which the sizes are typed</source>
        <translation>Einheit, in der die Größen eingegeben werden</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>Seite eines Markers</translation>
    </message>
    <message>
        <source>Of the black square around the pattern</source>
        <translation>Des schwarzen Quadrats um das Muster</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>Wörterbuch der Marker</translation>
    </message>
    <message>
        <source>As the program called it that made it</source>
        <translation>Wie das Programm es nannte, das die Tafel gemacht hat</translation>
    </message>
    <message>
        <source>Even rows of older software</source>
        <translation>Gerade Zeilenzahl älterer Software</translation>
    </message>
    <message>
        <source>A ChArUco board with an even number of rows from software older than OpenCV 4.6: its first square is white</source>
        <translation>Eine ChArUco-Tafel mit gerader Zeilenzahl aus Software vor OpenCV 4.6: ihr erstes Feld ist weiß</translation>
    </message>
    <message>
        <source>Black and white exchanged</source>
        <translation>Schwarz und Weiß vertauscht</translation>
    </message>
    <message>
        <source>White markers and corners on a black page</source>
        <translation>Weiße Marker und Ecken auf schwarzem Blatt</translation>
    </message>
    <message>
        <source>Print this board…</source>
        <translation>Diese Tafel drucken…</translation>
    </message>
    <message>
        <source>Write the board as a PDF in its true size, with a bar to check it with a ruler</source>
        <translation>Die Tafel in wahrer Größe als PDF schreiben, mit einem Balken zum Nachmessen</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Size of the sheet that is printed on</source>
        <translation>Größe des Blattes, auf das gedruckt wird</translation>
    </message>
    <message>
        <source>%1 × %2 inner corners; for the command line:</source>
        <translation>%1 × %2 innere Ecken; für die Befehlszeile:</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>Wörterbuch</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardGoalForm</name>
    <message>
        <source>Find</source>
        <translation>Gesucht</translation>
    </message>
    <message>
        <source>Lenses and places</source>
        <translation>Objektive und Standorte</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>Objektive</translation>
    </message>
    <message>
        <source>Places of the cameras</source>
        <translation>Standorte der Kameras</translation>
    </message>
    <message>
        <source>What is found</source>
        <translation>Was gefunden wird</translation>
    </message>
    <message>
        <source>Lenses: how each camera sees, by itself. Places: where the cameras stand, from a board that several of them see at once</source>
        <translation>Objektive: wie jede Kamera für sich sieht. Standorte: wo die Kameras stehen, aus einer Tafel, die mehrere zugleich sehen</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Objektivmodell</translation>
    </message>
    <message>
        <source>Pinhole, 5 coefficients</source>
        <translation>Lochkamera, 5 Koeffizienten</translation>
    </message>
    <message>
        <source>Pinhole, 8 coefficients (wide)</source>
        <translation>Lochkamera, 8 Koeffizienten (Weitwinkel)</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>Fischauge</translation>
    </message>
    <message>
        <source>5 for most lenses; 8 for wide ones; fisheye from about 120° on</source>
        <translation>5 für die meisten Objektive; 8 für weitwinklige; Fischauge ab etwa 120°</translation>
    </message>
    <message>
        <source>The board lies on the floor in frame</source>
        <translation>Die Tafel liegt auf dem Boden in Bild</translation>
    </message>
    <message>
        <source>That frame makes the world: X along the rows, Y to the upper edge, Z up. Without it the first camera keeps its place</source>
        <translation>Dieses Bild legt die Welt fest: X entlang der Zeilen, Y zur Oberkante, Z nach oben. Ohne es behält die erste Kamera ihren Platz</translation>
    </message>
    <message>
        <source>Frame in which the board lies on the floor</source>
        <translation>Bild, in dem die Tafel auf dem Boden liegt</translation>
    </message>
    <message>
        <source>Number of the frame</source>
        <translation>Nummer des Bildes</translation>
    </message>
    <message>
        <source>This one</source>
        <translation>Dieses</translation>
    </message>
    <message>
        <source>The frame shown</source>
        <translation>Das gezeigte Bild</translation>
    </message>
    <message>
        <source>Take the frame that is shown now</source>
        <translation>Das Bild nehmen, das jetzt gezeigt wird</translation>
    </message>
    <message>
        <source>Enough at</source>
        <translation>Genug bei</translation>
    </message>
    <message>
        <source>Accuracy wanted of lenses</source>
        <translation>Gewünschte Genauigkeit der Objektive</translation>
    </message>
    <message>
        <source>The guidance ends when a ray is known to so many pixels all over the image</source>
        <translation>Die Anleitung endet, wenn ein Strahl überall im Bild auf so viele Pixel bekannt ist</translation>
    </message>
    <message>
        <source>Accuracy wanted of places</source>
        <translation>Gewünschte Genauigkeit der Standorte</translation>
    </message>
    <message>
        <source>The guidance ends when the place of each camera is known so well</source>
        <translation>Die Anleitung endet, wenn der Standort jeder Kamera so genau bekannt ist</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardLive</name>
    <message>
        <source>How long the board was held still before %1</source>
        <translation>Wie lange die Tafel vor %1 still gehalten wurde</translation>
    </message>
    <message>
        <source>Where %1 saw the board</source>
        <translation>Wo %1 die Tafel sah</translation>
    </message>
    <message>
        <source>Filled: the regions and tilts that the board was shown in. Orange: what is asked for. Green: the board as it is seen now</source>
        <translation>Gefüllt: Bereiche und Neigungen, in denen die Tafel gezeigt wurde. Orange: was gewünscht ist. Grün: die Tafel, wie sie jetzt gesehen wird</translation>
    </message>
    <message>
        <source>Capture now</source>
        <translation>Jetzt aufnehmen</translation>
    </message>
    <message>
        <source>Take the board as it is shown now, also when it is not held still</source>
        <translation>Die Tafel nehmen, wie sie jetzt gezeigt wird, auch wenn sie nicht still gehalten wird</translation>
    </message>
    <message>
        <source>On the floor now</source>
        <translation>Liegt jetzt auf dem Boden</translation>
    </message>
    <message>
        <source>Take the board as it lies on the floor now: it makes the world. X along its rows, Y to its upper edge, Z up</source>
        <translation>Die Tafel nehmen, wie sie jetzt auf dem Boden liegt: sie legt die Welt fest. X entlang ihrer Zeilen, Y zu ihrer Oberkante, Z nach oben</translation>
    </message>
    <message>
        <source>Next: places</source>
        <translation>Weiter: Standorte</translation>
    </message>
    <message>
        <source>Leave the lenses as well known as they are, and show the board to several cameras at once</source>
        <translation>Die Objektive so genau lassen, wie sie bekannt sind, und die Tafel mehreren Kameras zugleich zeigen</translation>
    </message>
    <message>
        <source>Calibrate with these views</source>
        <translation>Mit diesen Ansichten kalibrieren</translation>
    </message>
    <message>
        <source>End here: what was taken so far is enough</source>
        <translation>Hier aufhören: was bisher aufgenommen wurde, genügt</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Look for the board in the live images, and be told what to show</source>
        <translation>Die Tafel in den Livebildern suchen und sagen, was zu zeigen ist</translation>
    </message>
    <message>
        <source>Waiting for images: are the cameras playing?</source>
        <translation>Warte auf Bilder: laufen die Kameras?</translation>
    </message>
    <message>
        <source>Show the board to one camera after the other, as each of them asks.</source>
        <translation>Zeigen Sie die Tafel einer Kamera nach der anderen, wie jede es verlangt.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxExportDialog</name>
    <message>
        <source>Export boxes</source>
        <translation>Rahmen exportieren</translation>
    </message>
    <message>
        <source>Two files are written: boxes.csv (a row per target and frame: box, center, similarity, seen or hidden) and boxes_mot.txt (the format of the MOT challenge). All in pixels.</source>
        <translation>Zwei Dateien werden geschrieben: boxes.csv (eine Zeile je Ziel und Bild: Rahmen, Mitte, Ähnlichkeit, gesehen oder verdeckt) und boxes_mot.txt (das Format der MOT Challenge). Alles in Pixeln.</translation>
    </message>
    <message>
        <source>How boxes.csv begins</source>
        <translation>Wie boxes.csv beginnt</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Both files go there; it is made if need be</source>
        <translation>Beide Dateien kommen dorthin; er wird bei Bedarf angelegt</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of the files</source>
        <translation>Den Ordner der Dateien wählen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write both files (Enter)</source>
        <translation>Beide Dateien schreiben (Eingabetaste)</translation>
    </message>
    <message>
        <source>Folder of the boxes</source>
        <translation>Ordner der Rahmen</translation>
    </message>
    <message>
        <source>boxes.csv and boxes_mot.txt are in %1.</source>
        <translation>boxes.csv und boxes_mot.txt liegen in %1.</translation>
    </message>
    <message>
        <source>The boxes of another export are there already. Replace them?</source>
        <translation>Dort liegen schon die Rahmen eines anderen Exports. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 gibt es schon; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxModel</name>
    <message>
        <source>● held</source>
        <translation>● gehalten</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ verdeckt</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Seconds, of the frame</source>
        <translation>Sekunden, des Bildes</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>Bild, ab 1 gezählt</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Name des Ziels</translation>
    </message>
    <message>
        <source>x, px</source>
        <translation>x, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the left edge of the image</source>
        <translation>Mitte des Rahmens, Pixel vom linken Bildrand</translation>
    </message>
    <message>
        <source>y, px</source>
        <translation>y, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the upper edge of the image</source>
        <translation>Mitte des Rahmens, Pixel vom oberen Bildrand</translation>
    </message>
    <message>
        <source>width, px</source>
        <translation>Breite, px</translation>
    </message>
    <message>
        <source>Width of the box, pixels</source>
        <translation>Breite des Rahmens, Pixel</translation>
    </message>
    <message>
        <source>height, px</source>
        <translation>Höhe, px</translation>
    </message>
    <message>
        <source>Height of the box, pixels</source>
        <translation>Höhe des Rahmens, Pixel</translation>
    </message>
    <message>
        <source>similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <source>How alike the colors in the box are to those it was given with, 0 to 1</source>
        <translation>Wie ähnlich die Farben im Rahmen denen sind, mit denen er gegeben wurde, 0 bis 1</translation>
    </message>
    <message>
        <source>spread, px</source>
        <translation>Streuung, px</translation>
    </message>
    <message>
        <source>Root mean square distance of the particles to their mean</source>
        <translation>Mittlerer quadratischer Abstand (RMS) der Partikel von ihrem Mittel</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Hidden: it is held where it is thought to be</source>
        <translation>Verdeckt: Es wird gehalten, wo es vermutet wird</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPanel</name>
    <message>
        <source>Boxes of the targets</source>
        <translation>Rahmen der Ziele</translation>
    </message>
    <message>
        <source>This method follows boxes in images: click the thing or drag a box around it in any camera view. Its box in every frame appears here, in pixels.</source>
        <translation>Dieses Verfahren folgt Rahmen in Bildern: Das Ding in einer Kameraansicht anklicken oder einen Rahmen darum ziehen. Hier erscheint sein Rahmen in jedem Bild, in Pixeln.</translation>
    </message>
    <message numerus="yes">
        <source>%n boxes, in pixels of the image</source>
        <translation>
            <numerusform>%n Rahmen, in Pixeln des Bildes</numerusform>
            <numerusform>%n Rahmen, in Pixeln des Bildes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPicker</name>
    <message>
        <source>This camera shows no image to take a box from.</source>
        <translation>Diese Kamera zeigt kein Bild, aus dem ein Rahmen genommen werden könnte.</translation>
    </message>
    <message>
        <source>Box of %1</source>
        <translation>Rahmen von %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationChoice</name>
    <message>
        <source>Calibration:</source>
        <translation>Kalibrierung:</translation>
    </message>
    <message>
        <source>Choose calibration…</source>
        <translation>Kalibrierung wählen…</translation>
    </message>
    <message>
        <source>A calibration file of Dewpoint or another program; cameras are found by their names, or else taken in its order</source>
        <translation>Eine Kalibrierungsdatei von Dewpoint oder einem anderen Programm; Kameras werden nach ihren Namen gefunden, sonst in ihrer Reihenfolge genommen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Go without a calibration file</source>
        <translation>Ohne Kalibrierungsdatei</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Eine Kalibrierung wählen</translation>
    </message>
    <message>
        <source>Recognized: %1. It leaves something open: %2. Create the project without it; then Import calibration asks for what is missing.</source>
        <translation>Erkannt: %1. Etwas bleibt darin offen: %2. Erstellen Sie das Projekt ohne sie; „Kalibrierung importieren“ fragt dann nach dem, was fehlt.</translation>
    </message>
    <message>
        <source>Recognized: %1. It cannot be used: %2.</source>
        <translation>Erkannt: %1. Sie lässt sich nicht verwenden: %2.</translation>
    </message>
    <message>
        <source>The file cannot be used: %1.</source>
        <translation>Die Datei lässt sich nicht verwenden: %1.</translation>
    </message>
    <message>
        <source>Not recognized. Dewpoint reads: %1.</source>
        <translation>Nicht erkannt. Dewpoint liest: %1.</translation>
    </message>
    <message>
        <source>Recognized: %1. Its cameras do not fit those above: %2.</source>
        <translation>Erkannt: %1. Ihre Kameras passen nicht zu denen oben: %2.</translation>
    </message>
    <message numerus="yes">
        <source>✓ Recognized: %1, %n cameras</source>
        <translation>
            <numerusform>✓ Erkannt: %1, %n Kamera</numerusform>
            <numerusform>✓ Erkannt: %1, %n Kameras</numerusform>
        </translation>
    </message>
    <message>
        <source>None: camera positions will be a guess</source>
        <translation>Keine: Die Kamerapositionen werden geraten</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationDock</name>
    <message>
        <source>Ways to calibrate</source>
        <translation>Arten zu kalibrieren</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationExportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Export the calibration</source>
        <translation>Kalibrierung exportieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the file; one that exists is replaced</source>
        <translation>Die Datei schreiben; eine vorhandene wird ersetzt</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>The program that is to read the file</source>
        <translation>Das Programm, das die Datei lesen soll</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Of lengths, where the format leaves it open</source>
        <translation>Der Längen, wo das Format sie offen lässt</translation>
    </message>
    <message>
        <source>as usual for the format</source>
        <translation>wie im Format üblich</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>%1: largest reprojection difference %2 (fitted anew)</source>
        <translation>%1: größter Unterschied der Rückprojektion %2 (neu angepasst)</translation>
    </message>
    <message>
        <source>%1: largest reprojection difference %2</source>
        <translation>%1: größter Unterschied der Rückprojektion %2</translation>
    </message>
    <message>
        <source>%1: %2 of 81 directions have no pixel any more</source>
        <translation>%1: %2 von 81 Richtungen haben kein Pixel mehr</translation>
    </message>
    <message>
        <source>%1 exists and will be replaced.</source>
        <translation>%1 gibt es schon und wird ersetzt.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationImportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>Eine Kalibrierung importieren</translation>
    </message>
    <message>
        <source>as the names say</source>
        <translation>wie die Namen sagen</translation>
    </message>
    <message>
        <source>only %1</source>
        <translation>nur %1</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Find a folder with a file for each camera</source>
        <translation>Einen Ordner mit einer Datei je Kamera suchen</translation>
    </message>
    <message>
        <source>Use these cameras</source>
        <translation>Diese Kameras verwenden</translation>
    </message>
    <message>
        <source>Take the calibration into the project; it can be undone</source>
        <translation>Die Kalibrierung ins Projekt übernehmen; das lässt sich zurücknehmen</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie die Datei sagt</translation>
    </message>
    <message>
        <source>recognized from the content</source>
        <translation>am Inhalt erkannt</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>k1 k2 p1 p2 of a pinhole</source>
        <translation>k1 k2 p1 p2 einer Lochkamera</translation>
    </message>
    <message>
        <source>k1 k2 k3 k4 of a fisheye</source>
        <translation>k1 k2 k3 k4 eines Fischauges</translation>
    </message>
    <message>
        <source>as the format has them</source>
        <translation>wie im Format</translation>
    </message>
    <message>
        <source>camera from world</source>
        <translation>Kamera aus Welt</translation>
    </message>
    <message>
        <source>world from camera</source>
        <translation>Welt aus Kamera</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>The program that wrote the file</source>
        <translation>Das Programm, das die Datei geschrieben hat</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Of lengths in the file; or type the meters of one unit, such as 0.025 for squares of 25 mm</source>
        <translation>Der Längen in der Datei; oder tippen Sie die Meter einer Einheit, etwa 0.025 für Felder von 25 mm</translation>
    </message>
    <message>
        <source>Four coefficients</source>
        <translation>Vier Koeffizienten</translation>
    </message>
    <message>
        <source>What four lens coefficients mean</source>
        <translation>Was vier Objektivkoeffizienten bedeuten</translation>
    </message>
    <message>
        <source>Size of images</source>
        <translation>Bildgröße</translation>
    </message>
    <message>
        <source>Width and height in pixels, such as 1280x720</source>
        <translation>Breite und Höhe in Pixeln, etwa 1280x720</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Which way the poses in the file go</source>
        <translation>In welche Richtung die Lagen der Datei gehen</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Für</translation>
    </message>
    <message>
        <source>Which camera a file of one camera is about</source>
        <translation>Um welche Kamera es in einer Datei mit einer Kamera geht</translation>
    </message>
    <message>
        <source>The file leaves something open. Answer “%1” above.</source>
        <translation>Die Datei lässt etwas offen. Beantworten Sie oben „%1“.</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>Die Kalibrierung nennt ihre Kameras anders: Sie wurden in ihrer Reihenfolge genommen.</translation>
    </message>
    <message>
        <source>There is no pose in the file: only the lens is taken, the pose stays.</source>
        <translation>In der Datei steht keine Lage: nur das Objektiv wird übernommen, die Lage bleibt.</translation>
    </message>
    <message>
        <source>%1 (in the file: %2): %3 and %4 from where it is now</source>
        <translation>%1 (in der Datei: %2): %3 und %4 von da, wo sie jetzt ist</translation>
    </message>
    <message>
        <source>Largest reprojection difference to the file: %1</source>
        <translation>Größter Unterschied der Rückprojektion zur Datei: %1</translation>
    </message>
    <message>
        <source>Import calibration</source>
        <translation>Kalibrierung importieren</translation>
    </message>
    <message>
        <source>The cameras have the calibration of %1 now.</source>
        <translation>Die Kameras haben jetzt die Kalibrierung aus %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationMode</name>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraAgreementAlerts</name>
    <message>
        <source>Calibrate %1…</source>
        <translation>%1 kalibrieren…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraForm</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>The camera that is adjusted; clicking into its image chooses it too</source>
        <translation>Die Kamera, die eingestellt wird; ein Klick in ihr Bild wählt sie auch</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Unit of positions</source>
        <translation>Einheit der Positionen</translation>
    </message>
    <message>
        <source>Unit in which positions are shown and typed</source>
        <translation>Einheit, in der Positionen gezeigt und eingegeben werden</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Blick</translation>
    </message>
    <message>
        <source>at a point, roll</source>
        <translation>auf einen Punkt, Rollen</translation>
    </message>
    <message>
        <source>yaw, pitch, roll</source>
        <translation>Gieren, Nicken, Rollen</translation>
    </message>
    <message>
        <source>How the direction is said</source>
        <translation>Wie die Richtung angegeben wird</translation>
    </message>
    <message>
        <source>A point that the camera looks at, or angles: yaw from x toward y, pitch above the horizon, roll about the line of sight</source>
        <translation>Ein Punkt, auf den die Kamera blickt, oder Winkel: Gieren von x nach y, Nicken über dem Horizont, Rollen um die Blickrichtung</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>How the lens is said</source>
        <translation>Wie das Objektiv angegeben wird</translation>
    </message>
    <message>
        <source>Focal length in pixels, or the horizontal field of view in degrees</source>
        <translation>Brennweite in Pixeln oder waagerechter Bildwinkel in Grad</translation>
    </message>
    <message>
        <source>Focal length or field of view</source>
        <translation>Brennweite oder Bildwinkel</translation>
    </message>
    <message>
        <source>How much the camera magnifies; the keys + and − change it too</source>
        <translation>Wie stark die Kamera vergrößert; auch die Tasten + und − ändern es</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>turns the camera</source>
        <translation>dreht die Kamera</translation>
    </message>
    <message>
        <source>slides the camera</source>
        <translation>verschiebt die Kamera</translation>
    </message>
    <message>
        <source>What dragging does</source>
        <translation>Was Ziehen bewirkt</translation>
    </message>
    <message>
        <source>What the camera does while the grid is dragged and nothing is held. Click points of the grid to hold up to three of them.</source>
        <translation>Was die Kamera tut, während das Gitter gezogen wird und nichts festgehalten ist. Klicks auf Punkte des Gitters halten bis zu drei davon fest.</translation>
    </message>
    <message>
        <source>Three held points: the focal length gives way</source>
        <translation>Drei gehaltene Punkte: die Brennweite gibt nach</translation>
    </message>
    <message>
        <source>Three held points fix the pose; dragging then changes the focal length, and the camera follows</source>
        <translation>Drei gehaltene Punkte legen die Pose fest; Ziehen ändert dann die Brennweite, und die Kamera folgt</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>move</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>What keys do</source>
        <translation>Was Tasten bewirken</translation>
    </message>
    <message>
        <source>Arrows or W A S D, with Q and E or the page keys: 1 cm or 0.2° a step. Shift: ten times as much; Ctrl with arrows and page keys: a tenth.</source>
        <translation>Pfeile oder W A S D, dazu Q und E oder die Bildtasten: 1 cm oder 0,2° je Schritt. Umschalt: das Zehnfache; Strg mit Pfeilen und Bildtasten: ein Zehntel.</translation>
    </message>
    <message>
        <source>as it looks</source>
        <translation>wie sie blickt</translation>
    </message>
    <message>
        <source>along x, y, z</source>
        <translation>entlang x, y, z</translation>
    </message>
    <message>
        <source>Directions of keys</source>
        <translation>Richtungen der Tasten</translation>
    </message>
    <message>
        <source>Right, forward and up as the camera looks, or the axes of the world</source>
        <translation>Rechts, vorwärts und aufwärts, wie die Kamera blickt, oder die Achsen der Welt</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>Where the camera stands, along %1</source>
        <translation>Wo die Kamera steht, entlang %1</translation>
    </message>
    <message>
        <source>Looks at %1</source>
        <translation>Blickt auf %1</translation>
    </message>
    <message>
        <source>The point the camera looks at, along %1</source>
        <translation>Der Punkt, auf den die Kamera blickt, entlang %1</translation>
    </message>
    <message>
        <source>Direction from above: 0° along x, 90° along y</source>
        <translation>Richtung von oben: 0° entlang x, 90° entlang y</translation>
    </message>
    <message>
        <source>Above the horizon; straight down is −90°</source>
        <translation>Über dem Horizont; senkrecht hinab ist −90°</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Turned about its line of sight, clockwise</source>
        <translation>Um die Blickrichtung gedreht, im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>looks at</source>
        <translation>blickt auf</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraMotionAlerts</name>
    <message>
        <source>%1 was %2 (frame %3).</source>
        <translation>%1 wurde %2 (Bild %3).</translation>
    </message>
    <message>
        <source>Its new pose is being worked out.</source>
        <translation>Ihre neue Lage wird gerade bestimmt.</translation>
    </message>
    <message>
        <source>Its pose can be solved again from what it sees.</source>
        <translation>Ihre Lage lässt sich aus dem, was sie sieht, neu bestimmen.</translation>
    </message>
    <message>
        <source>Re-solve %1</source>
        <translation>%1 neu bestimmen</translation>
    </message>
    <message>
        <source>It cannot be solved again from what it sees: calibrate it anew, or put it back.</source>
        <translation>Aus dem, was sie sieht, lässt sich das nicht neu bestimmen: neu kalibrieren oder zurückstellen.</translation>
    </message>
    <message>
        <source>Calibrate %1…</source>
        <translation>%1 kalibrieren…</translation>
    </message>
    <message>
        <source>%1 stands again as it was calibrated.</source>
        <translation>%1 steht wieder so, wie sie kalibriert wurde.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraPanel</name>
    <message>
        <source>Rename camera</source>
        <translation>Kamera umbenennen</translation>
    </message>
    <message>
        <source>Change source of images</source>
        <translation>Quelle der Bilder ändern</translation>
    </message>
    <message>
        <source>Turn images</source>
        <translation>Bilder drehen</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Eine Kalibrierung wählen</translation>
    </message>
    <message>
        <source>Calibrations (*.toml);;All files (*)</source>
        <translation>Kalibrierungen (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>Name der Kamera, in Ansichten und Dateien</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Video file, folder of images, device or address of a stream</source>
        <translation>Videodatei, Ordner mit Bildern, Gerät oder Adresse eines Stroms</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Find the recording of this camera in another place</source>
        <translation>Die Aufnahme dieser Kamera an einem anderen Ort finden</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>Images are turned clockwise by so much before use</source>
        <translation>Bilder werden vor Gebrauch um so viel im Uhrzeigersinn gedreht</translation>
    </message>
    <message>
        <source>Load calibration…</source>
        <translation>Kalibrierung laden…</translation>
    </message>
    <message>
        <source>Take the calibration of all cameras from a file</source>
        <translation>Die Kalibrierung aller Kameras aus einer Datei nehmen</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, focal length %3 pixels
at %4, %5, %6</source>
        <translation>%1 × %2 Pixel, Brennweite %3 Pixel
bei %4, %5, %6</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Einen Ordner mit Bildern wählen</translation>
    </message>
    <message>
        <source>Choose the video of this camera</source>
        <translation>Das Video dieser Kamera wählen</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Bilder spiegeln</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Images are mirrored left to right, after they were turned</source>
        <translation>Bilder werden nach dem Drehen seitenverkehrt</translation>
    </message>
    <message>
        <source>Empty room</source>
        <translation>Leerer Raum</translation>
    </message>
    <message>
        <source>Image, video or folder of images in which this camera shows the scene without any target: what has its color there is not taken for it</source>
        <translation>Bild, Video oder Ordner mit Bildern, in denen diese Kamera die Szene ohne Ziel zeigt: Was dort seine Farbe hat, wird nicht für das Ziel gehalten</translation>
    </message>
    <message>
        <source>Choose the empty room</source>
        <translation>Leeren Raum wählen</translation>
    </message>
    <message>
        <source>Find an image or a video of the scene without any target</source>
        <translation>Ein Bild oder Video der Szene ohne Ziel suchen</translation>
    </message>
    <message>
        <source>Use the image shown</source>
        <translation>Gezeigtes Bild verwenden</translation>
    </message>
    <message>
        <source>Keep the image this camera shows now as the one of the empty room</source>
        <translation>Das Bild, das diese Kamera jetzt zeigt, als das des leeren Raums behalten</translation>
    </message>
    <message>
        <source>Change empty room</source>
        <translation>Leeren Raum ändern</translation>
    </message>
    <message>
        <source>Choose an image or a video of the empty room</source>
        <translation>Bild oder Video des leeren Raums wählen</translation>
    </message>
    <message>
        <source>Change how late the images are</source>
        <translation>Verspätung der Bilder ändern</translation>
    </message>
    <message>
        <source>Late by</source>
        <translation>Verspätet um</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Milliseconds by which its images are late: they are put together with those of the other cameras by it. Calibrate by waving finds it</source>
        <translation>Millisekunden, um die ihre Bilder zu spät sind: Danach werden sie den Bildern der anderen Kameras zugeordnet. „Durch Schwenken kalibrieren“ findet sie</translation>
    </message>
    <message>
        <source>Milliseconds by which the images are late</source>
        <translation>Millisekunden, um die die Bilder zu spät sind</translation>
    </message>
    <message>
        <source>Load calibration</source>
        <translation>Kalibrierung laden</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>Die Kalibrierung nennt ihre Kameras anders: Sie wurden in ihrer Reihenfolge genommen.</translation>
    </message>
    <message>
        <source>The cameras have the calibration of %1 now.</source>
        <translation>Die Kameras haben jetzt die Kalibrierung aus %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraTable</name>
    <message>
        <source>rtsp://192.168.0.10/stream, or a device number such as 0</source>
        <translation>rtsp://192.168.0.10/stream oder eine Gerätenummer wie 0</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %3 frames per second · %n frames</source>
        <translation>
            <numerusform>✓ %1×%2 · %3 Bilder je Sekunde · %n Bild</numerusform>
            <numerusform>✓ %1×%2 · %3 Bilder je Sekunde · %n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %n images</source>
        <translation>
            <numerusform>✓ %1×%2 · %n Bild</numerusform>
            <numerusform>✓ %1×%2 · %n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Live: tried when the project is made</source>
        <translation>Live: wird ausprobiert, wenn das Projekt erstellt wird</translation>
    </message>
    <message>
        <source>Videos differ in frame rate: frame N of one is not the same moment as frame N of the other.</source>
        <translation>Die Videos haben verschiedene Bildraten: Bild N des einen ist nicht derselbe Moment wie Bild N des anderen.</translation>
    </message>
    <message numerus="yes">
        <source>Videos differ in length: using the first %n frames.</source>
        <translation>
            <numerusform>Die Videos sind verschieden lang: Nur das erste Bild (%n) wird verwendet.</numerusform>
            <numerusform>Die Videos sind verschieden lang: Die ersten %n Bilder werden verwendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Videos differ in size: each camera keeps its own.</source>
        <translation>Die Videos sind verschieden groß: Jede Kamera behält ihre Größe.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraView</name>
    <message>
        <source>This camera delivered no image for this frame.</source>
        <translation>Diese Kamera lieferte zu diesem Zeitpunkt kein Bild.</translation>
    </message>
    <message>
        <source>No images yet. Press play (Space), or open a project (Ctrl+O).</source>
        <translation>Noch keine Bilder. Wiedergabe starten (Leertaste) oder ein Projekt öffnen (Strg+O).</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ChangesGuard</name>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml)</source>
        <translation>Dewpoint-Projekte (*.toml)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to this project?</source>
        <translation>Die Änderungen an diesem Projekt speichern?</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorChoice</name>
    <message>
        <source>Color %1</source>
        <translation>Farbe %1</translation>
    </message>
    <message>
        <source>Show this color, so that its range can be changed by hand</source>
        <translation>Diese Farbe des Ziels zeigen, um ihren Bereich von Hand zu ändern</translation>
    </message>
    <message>
        <source>Colors of the target</source>
        <translation>Farben des Ziels</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove this color from the target, and the samples that show it</source>
        <translation>Diese Farbe vom Ziel wegnehmen, samt den Proben, die sie zeigen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorDock</name>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Take a box here</source>
        <translation>Hier Rahmen nehmen</translation>
    </message>
    <message>
        <source>Learn the color here</source>
        <translation>Hier Farbe lernen</translation>
    </message>
    <message>
        <source>Add a sample here</source>
        <translation>Hier Probe hinzufügen</translation>
    </message>
    <message>
        <source>This is not the target</source>
        <translation>Das ist nicht das Ziel</translation>
    </message>
    <message>
        <source>Track this object, starting from a box around it</source>
        <translation>Dieses Objekt verfolgen, ausgehend von einem Rahmen darum</translation>
    </message>
    <message>
        <source>Learn the target&apos;s color from this spot</source>
        <translation>Die Farbe des Ziels an dieser Stelle lernen</translation>
    </message>
    <message>
        <source>Add this color to the target&apos;s (Shift-click does the same)</source>
        <translation>Diese Farbe zu denen des Ziels hinzufügen (Umschalt-Klick tut dasselbe)</translation>
    </message>
    <message>
        <source>Exclude this color (Alt-click does the same)</source>
        <translation>Diese Farbe ausschließen (Alt-Klick tut dasselbe)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLearner</name>
    <message>
        <source>This camera shows no image to learn from.</source>
        <translation>Diese Kamera zeigt kein Bild, aus dem gelernt werden kann.</translation>
    </message>
    <message>
        <source>Click the target first; then exclude what is not it.</source>
        <translation>Erst das Ziel anklicken; dann ausschließen, was es nicht ist.</translation>
    </message>
    <message>
        <source>Exclude color</source>
        <translation>Farbe ausschließen</translation>
    </message>
    <message>
        <source>Add color sample</source>
        <translation>Farbprobe hinzufügen</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>Farbe lernen</translation>
    </message>
    <message>
        <source>Remove color sample</source>
        <translation>Farbprobe entfernen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPanel</name>
    <message>
        <source>Looking at the images…</source>
        <translation>Die Bilder werden betrachtet …</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>Noch kein Ziel</translation>
    </message>
    <message>
        <source>A new target</source>
        <translation>Ein neues Ziel</translation>
    </message>
    <message>
        <source>Drag ring and bars, or press Learn and click the target.</source>
        <translation>Ring und Balken ziehen, oder Lernen drücken und das Ziel anklicken.</translation>
    </message>
    <message>
        <source>Click the thing to follow in any camera image.</source>
        <translation>In irgendeinem Kamerabild auf das klicken, was verfolgt werden soll.</translation>
    </message>
    <message>
        <source>Change color range</source>
        <translation>Farbbereich ändern</translation>
    </message>
    <message>
        <source>Click the thing to follow</source>
        <translation>Klicke an, was verfolgt werden soll</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it</source>
        <translation>Das Ding anklicken oder einen Rahmen darum ziehen</translation>
    </message>
    <message>
        <source>Followed from its box in %1, frame %2: %3 × %4. This method needs no color; press Box and click the thing for another box.</source>
        <translation>Verfolgt von seinem Rahmen in %1 an, Bild %2: %3 × %4. Dieses Verfahren braucht keine Farbe; für einen anderen Rahmen auf Rahmen drücken und das Ding anklicken.</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>Das Ding in einer Kameraansicht anklicken oder einen Rahmen darum ziehen.</translation>
    </message>
    <message>
        <source>Remove color</source>
        <translation>Farbe entfernen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPicker</name>
    <message>
        <source>H&amp;ue</source>
        <translation>&amp;Farbton</translation>
    </message>
    <message>
        <source>&amp;Saturation</source>
        <translation>&amp;Sättigung</translation>
    </message>
    <message>
        <source>&amp;Intensity</source>
        <translation>&amp;Intensität</translation>
    </message>
    <message>
        <source>First hue, 0 to 360 degrees; above the last hue the range goes through red</source>
        <translation>Erster Farbton, 0 bis 360 Grad; über dem letzten Farbton geht der Bereich durch Rot</translation>
    </message>
    <message>
        <source>Last hue, 0 to 360 degrees</source>
        <translation>Letzter Farbton, 0 bis 360 Grad</translation>
    </message>
    <message>
        <source>Least saturation, 0 to 1</source>
        <translation>Kleinste Sättigung, 0 bis 1</translation>
    </message>
    <message>
        <source>Greatest saturation, 0 to 1</source>
        <translation>Größte Sättigung, 0 bis 1</translation>
    </message>
    <message>
        <source>Least intensity, 0 to 1</source>
        <translation>Kleinste Intensität, 0 bis 1</translation>
    </message>
    <message>
        <source>Greatest intensity, 0 to 1</source>
        <translation>Größte Intensität, 0 bis 1</translation>
    </message>
    <message>
        <source>Drag the ends or the middle; with the keyboard, Tab chooses and the arrows move (with Shift ten times as far)</source>
        <translation>Enden oder Mitte ziehen; mit der Tastatur wählt Tab, und die Pfeile bewegen (mit Umschalt zehnmal so weit)</translation>
    </message>
    <message>
        <source>Range of hues</source>
        <translation>Bereich der Farbtöne</translation>
    </message>
    <message>
        <source>Range of saturation</source>
        <translation>Bereich der Sättigung</translation>
    </message>
    <message>
        <source>Range of intensity</source>
        <translation>Bereich der Intensität</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorSampleList</name>
    <message>
        <source>Learned from</source>
        <translation>Gelernt aus</translation>
    </message>
    <message>
        <source>Samples the color was learned from</source>
        <translation>Proben, aus denen die Farbe gelernt wurde</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>not this: %1, frame %2, at %3, %4</source>
        <translation>dies nicht: %1, Bild %2, bei %3, %4</translation>
    </message>
    <message>
        <source>%1, frame %2, at %3, %4</source>
        <translation>%1, Bild %2, bei %3, %4</translation>
    </message>
    <message>
        <source>found: %1, frame %2, at %3, %4</source>
        <translation>gefunden: %1, Bild %2, bei %3, %4</translation>
    </message>
    <message>
        <source>Shift-click in an image adds one, Alt-click or Ctrl+Shift-click excludes one. Samples marked “found” were not clicked, but found in other cameras.</source>
        <translation>Umschalt+Klick in einem Bild fügt eine hinzu, Alt+Klick oder Strg+Umschalt+Klick schließt eine aus. Mit „gefunden“ bezeichnete Proben wurden nicht angeklickt, sondern in anderen Kameras gefunden.</translation>
    </message>
    <message>
        <source>Forget the chosen sample and learn from the rest (Del). A found sample becomes an excluded one.</source>
        <translation>Die gewählte Probe vergessen und aus den übrigen lernen (Entf). Eine gefundene Probe wird zu einer ausgeschlossenen.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Aktionen suchen</translation>
    </message>
    <message>
        <source>Actions found</source>
        <translation>Gefundene Aktionen</translation>
    </message>
    <message>
        <source>Nothing here is called “%1”.</source>
        <translation>Hier heißt nichts „%1“.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionMode</name>
    <message>
        <source>Drag the target in an image to where it is; the same in another image fixes its depth. Esc ends it.</source>
        <translation>Das Ziel in einem Bild dorthin ziehen, wo es ist; dasselbe in einem zweiten Bild legt die Tiefe fest. Esc beendet es.</translation>
    </message>
    <message>
        <source>Correct position</source>
        <translation>Position korrigieren</translation>
    </message>
    <message>
        <source>There is no correction in this frame.</source>
        <translation>In diesem Bild gibt es keine Korrektur.</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Korrektur entfernen</translation>
    </message>
    <message>
        <source>Say that the target is here in the frame shown: tracking goes on from there</source>
        <translation>Sagen, dass das Ziel im gezeigten Bild hier ist: Von dort wird weiter verfolgt</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionTool</name>
    <message>
        <source>Drag the target to where it is</source>
        <translation>Das Ziel dorthin ziehen, wo es ist</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter says that the target is there</source>
        <translation>Bild von %1: Pfeiltasten bewegen ein Kreuz, Eingabe sagt, dass das Ziel dort ist</translation>
    </message>
    <message>
        <source>Frames are being tracked again: wait until that is done, or pause.</source>
        <translation>Bilder werden neu verfolgt: Warten Sie, bis das fertig ist, oder halten Sie an.</translation>
    </message>
    <message>
        <source>There is no target yet: learn its color first.</source>
        <translation>Es gibt noch kein Ziel: Lernen Sie zuerst seine Farbe.</translation>
    </message>
    <message>
        <source>Drag an estimate, or select the target in the list first.</source>
        <translation>Ziehen Sie eine Schätzung, oder wählen Sie zuerst das Ziel in der Liste.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CoverageMap</name>
    <message>
        <source>%1: seen %2 times, in %3 of %4 regions of the image</source>
        <translation>%1: %2-mal gesehen, in %3 von %4 Teilen des Bildes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DockTitle</name>
    <message>
        <source>Float this view, or put it back (double click the title: whole window)</source>
        <translation>Diese Ansicht lösen oder zurücksetzen (Doppelklick auf den Titel: ganzes Fenster)</translation>
    </message>
    <message>
        <source>Show all views</source>
        <translation>Alle Ansichten zeigen</translation>
    </message>
    <message>
        <source>Give the other views their places back (Esc, or double click here)</source>
        <translation>Den anderen Ansichten ihre Plätze zurückgeben (Esc oder Doppelklick hier)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Document</name>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message>
        <source>Track by “%1”</source>
        <translation>Mit „%1“ verfolgen</translation>
    </message>
    <message>
        <source>Reset “%1”</source>
        <translation>„%1“ zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Alle Parameter zurücksetzen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DropZone</name>
    <message>
        <source>Drop videos here, or add them</source>
        <translation>Videos hierher ziehen oder hinzufügen</translation>
    </message>
    <message>
        <source>One per camera; also folders of images, and a calibration file</source>
        <translation>Eines je Kamera; auch Ordner mit Bildern und eine Kalibrierungsdatei</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExchangeDialog</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>The file, or the folder with a file for each camera</source>
        <translation>Die Datei, oder der Ordner mit einer Datei je Kamera</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Find the file</source>
        <translation>Die Datei suchen</translation>
    </message>
    <message>
        <source>What is decided</source>
        <translation>Was entschieden ist</translation>
    </message>
    <message>
        <source>Choose a file. What is decided about it is shown here before anything changes.</source>
        <translation>Wählen Sie eine Datei. Was über sie entschieden wird, steht hier, bevor sich etwas ändert.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExperimentDialog</name>
    <message>
        <source>Canceled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Experimente</translation>
    </message>
    <message>
        <source>Number of seeds. More seeds take longer and give more certain results.</source>
        <translation>Wie viele Startzahlen: Mehr dauern länger und sind sicherer</translation>
    </message>
    <message>
        <source>The report, its pictures and its numbers go there</source>
        <translation>Dorthin kommen der Bericht, seine Bilder und seine Zahlen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of the report</source>
        <translation>Den Ordner des Berichts wählen</translation>
    </message>
    <message>
        <source>How far the experiment is</source>
        <translation>Wie weit das Experiment ist</translation>
    </message>
    <message>
        <source>Run the chosen experiment (Enter)</source>
        <translation>Das gewählte Experiment ausführen (Eingabe)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the experiment; nothing is written</source>
        <translation>Das Experiment anhalten; nichts wird geschrieben</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Show the last report in the web browser</source>
        <translation>Den letzten Bericht im Browser zeigen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>Ordner des Berichts</translation>
    </message>
    <message>
        <source>Name the folder of the report first.</source>
        <translation>Nenne zuerst den Ordner des Berichts.</translation>
    </message>
    <message>
        <source>Running “%1”…</source>
        <translation>„%1“ läuft …</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>Der Bericht liegt in %1.</translation>
    </message>
    <message>
        <source>Runs per case</source>
        <translation>Läufe je Fall</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Run it</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>Clothes</source>
        <translation>Kleidung</translation>
    </message>
    <message>
        <source>Whether the clothes of the simulated people tell them apart</source>
        <translation>Ob die Kleidung der simulierten Personen sie unterscheidet</translation>
    </message>
    <message>
        <source>both kinds</source>
        <translation>beide Arten</translation>
    </message>
    <message>
        <source>different</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>similar</source>
        <translation>ähnlich</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>none: a rendered clip only</source>
        <translation>keine: nur ein berechneter Film</translation>
    </message>
    <message>
        <source>Folder with the recordings juggle1 and otb; without one, a rendered clip only</source>
        <translation>Ordner mit den Aufnahmen juggle1 und otb; ohne ihn nur ein berechneter Film</translation>
    </message>
    <message>
        <source>Choose the folder of the recordings</source>
        <translation>Den Ordner der Aufnahmen wählen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportDialog</name>
    <message>
        <source>Export trajectory</source>
        <translation>Bahn exportieren</translation>
    </message>
    <message>
        <source>Write a figure</source>
        <translation>Abbildung schreiben</translation>
    </message>
    <message>
        <source>Figures (*.svg *.pdf)</source>
        <translation>Abbildungen (*.svg *.pdf)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>Der Export wurde abgebrochen.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Datei, die geschrieben wird</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>Die Datei wählen, die geschrieben wird</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the work under way; what is there already stays as it was</source>
        <translation>Die laufende Arbeit anhalten; was schon da ist, bleibt, wie es war</translation>
    </message>
    <message>
        <source>Figure…</source>
        <translation>Abbildung…</translation>
    </message>
    <message>
        <source>Write a figure of it as SVG or PDF: x, y, z over time and from above</source>
        <translation>Eine Abbildung als SVG oder PDF schreiben: x, y, z über der Zeit und von oben</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the file in the background</source>
        <translation>Die Datei im Hintergrund schreiben</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close; an export that is under way goes on</source>
        <translation>Schließen; ein laufender Export geht weiter</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 gibt es schon; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Which program is to read it</source>
        <translation>Welches Programm sie lesen soll</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Those with a mark are exported; all, if none has one</source>
        <translation>Die angekreuzten werden exportiert; alle, wenn keines angekreuzt ist</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>Schätzungen</translation>
    </message>
    <message>
        <source>As they were known live, or as all frames before and after tell</source>
        <translation>Wie sie live bekannt waren, oder wie alle Bilder davor und danach sie zeigen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>First time, 0 to 1,000,000 s</source>
        <translation>Erster Zeitpunkt, 0 bis 1.000.000 s</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Last time, 0 to 1,000,000 s</source>
        <translation>Letzter Zeitpunkt, 0 bis 1.000.000 s</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Rows per second, 0.001 to 10,000; interpolated</source>
        <translation>Zeilen pro Sekunde, 0,001 bis 10.000; interpoliert</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>What to write where the target is not known</source>
        <translation>Was geschrieben wird, wo das Ziel nicht bekannt ist</translation>
    </message>
    <message>
        <source>Longest gap</source>
        <translation>Längste Lücke</translation>
    </message>
    <message>
        <source>A longer gap is left, 0.01 to 60 s</source>
        <translation>Eine längere Lücke bleibt, 0,01 bis 60 s</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Weltachsen</translation>
    </message>
    <message>
        <source>Which axis points up in the file</source>
        <translation>Welche Achse in der Datei nach oben zeigt</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Unit of positions in the file</source>
        <translation>Einheit der Orte in der Datei</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>wie aufgenommen</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> pro Sekunde</translation>
    </message>
    <message>
        <source>Notes about the run</source>
        <translation>Angaben zum Lauf</translation>
    </message>
    <message>
        <source>Method, seed, parameters, units and axes as comments in the file</source>
        <translation>Verfahren, Startwert, Parameter, Einheiten und Achsen als Kommentare in der Datei</translation>
    </message>
    <message>
        <source>live</source>
        <translation>live</translation>
    </message>
    <message>
        <source>smoothed after the run</source>
        <translation>nach dem Lauf geglättet</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>lassen</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>füllen</translation>
    </message>
    <message>
        <source>as usual in the format</source>
        <translation>wie im Format üblich</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z nach oben</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y nach oben</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>Millimeter</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportOutcome</name>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Open the folder of the file that was written</source>
        <translation>Den Ordner der geschriebenen Datei öffnen</translation>
    </message>
    <message>
        <source>No file manager was found. The file is %1.</source>
        <translation>Kein Dateimanager wurde gefunden. Die Datei ist %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FollowAllButton</name>
    <message numerus="yes">
        <source>Follow all %n of them</source>
        <translation>
            <numerusform>%n davon verfolgen</numerusform>
            <numerusform>Alle %n verfolgen</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a target of the same color and size for each of the others</source>
        <translation>Für jedes der anderen ein Ziel derselben Farbe und Größe hinzufügen</translation>
    </message>
    <message>
        <source>Follow all of one color</source>
        <translation>Alle von einer Farbe verfolgen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GalleryCard</name>
    <message>
        <source>Opening…</source>
        <translation>Wird geöffnet…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GapList</name>
    <message>
        <source>Gaps of the trajectory</source>
        <translation>Lücken der Bahn</translation>
    </message>
    <message>
        <source>gap from</source>
        <translation>Lücke von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>Seconds from the last held estimate before the gap to the first one after it</source>
        <translation>Sekunden von der letzten gehaltenen Schätzung vor der Lücke bis zur ersten danach</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridForm</name>
    <message>
        <source>Change the reference grid</source>
        <translation>Bezugsgitter ändern</translation>
    </message>
    <message>
        <source>Grid on</source>
        <translation>Gitter auf</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>dem Boden</translation>
    </message>
    <message>
        <source>a wall</source>
        <translation>einer Wand</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>einem Quader</translation>
    </message>
    <message>
        <source>Kind of grid</source>
        <translation>Art des Gitters</translation>
    </message>
    <message>
        <source>What the grid lies on in the room</source>
        <translation>Worauf das Gitter im Raum liegt</translation>
    </message>
    <message>
        <source>Size along x, y, z</source>
        <translation>Größe entlang x, y, z</translation>
    </message>
    <message>
        <source>Begins at x, y, z</source>
        <translation>Beginnt bei x, y, z</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>Größe entlang %1</translation>
    </message>
    <message>
        <source>How far the grid reaches, in meters</source>
        <translation>Wie weit das Gitter reicht, in Metern</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Ursprung %1</translation>
    </message>
    <message>
        <source>The corner where its axes begin, in meters</source>
        <translation>Die Ecke, in der seine Achsen beginnen, in Metern</translation>
    </message>
    <message>
        <source>Step, turn</source>
        <translation>Schritt, Drehung</translation>
    </message>
    <message>
        <source>Step of the grid</source>
        <translation>Schritt des Gitters</translation>
    </message>
    <message>
        <source>Meters from line to line</source>
        <translation>Meter von Linie zu Linie</translation>
    </message>
    <message>
        <source>Turn of the grid</source>
        <translation>Drehung des Gitters</translation>
    </message>
    <message>
        <source>Turned about the vertical, counterclockwise from above</source>
        <translation>Um die Senkrechte gedreht, von oben gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the grid</source>
        <translation>Deckkraft des Gitters</translation>
    </message>
    <message>
        <source>How strongly the grid is drawn over the images</source>
        <translation>Wie kräftig das Gitter über den Bildern gezeichnet wird</translation>
    </message>
    <message>
        <source>Show edges of the images</source>
        <translation>Kanten der Bilder zeigen</translation>
    </message>
    <message>
        <source>Let the rest of the images step back behind their edges</source>
        <translation>Alles andere in den Bildern tritt hinter die Kanten zurück</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Show the cameras as they were before</source>
        <translation>Die Kameras zeigen, wie sie vorher waren</translation>
    </message>
    <message>
        <source>While held down (or B, over an image): the grid as it was when the calibration was opened</source>
        <translation>Solange gedrückt (oder B, über einem Bild): das Gitter, wie es beim Öffnen der Kalibrierung war</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridLayer</name>
    <message>
        <source>Grid over the image of %1</source>
        <translation>Gitter über dem Bild von %1</translation>
    </message>
    <message>
        <source>Drag the grid onto the real thing; click to hold a point; arrows, W A S D, Q and E move or turn the camera</source>
        <translation>Das Gitter auf das Wirkliche ziehen; Klick hält einen Punkt; Pfeile, W A S D, Q und E verschieben oder drehen die Kamera</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistogramView</name>
    <message>
        <source>Colors of the box</source>
        <translation>Farben des Rahmens</translation>
    </message>
    <message>
        <source>Color histograms of the bounding box: outlined bars for the reference, filled bars for the current frame. The largest of the 512 bins are shown, each in its own color.</source>
        <translation>Farbhistogramme des Rahmens: leere Balken, wie er angegeben wurde, gefüllte Balken, wie er jetzt ist. Gezeigt werden die größten von 512 Klassen, jede in ihrer Farbe.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistoryDock</name>
    <message>
        <source>As it was opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>History of changes</source>
        <translation>Verlauf der Änderungen</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ImagePickTool</name>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter points there</source>
        <translation>Bild von %1: Pfeiltasten bewegen ein Kreuz, Enter zeigt dorthin</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LearnModes</name>
    <message>
        <source>What a click in an image does</source>
        <translation>Was ein Klick in ein Bild bewirkt</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Add sample</source>
        <translation>Probe hinzufügen</translation>
    </message>
    <message>
        <source>Not this</source>
        <translation>Dies nicht</translation>
    </message>
    <message>
        <source>Learn the color first: click the target in a camera image.</source>
        <translation>Erst die Farbe lernen: das Ziel in einem Kamerabild anklicken.</translation>
    </message>
    <message>
        <source>Click: add a sample · Alt: not this · Esc</source>
        <translation>Klick: Probe hinzufügen · Alt: dies nicht · Esc</translation>
    </message>
    <message>
        <source>Click what is not the target · Esc</source>
        <translation>Anklicken, was nicht das Ziel ist · Esc</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Alt: not this · Esc</source>
        <translation>Klick: lernen · Umschalt: hinzufügen · Alt: dies nicht · Esc</translation>
    </message>
    <message>
        <source>Click the object in a camera image, or drag a box around it.
Shift-click works at any time.</source>
        <translation>Das Objekt in einem Kamerabild anklicken oder einen Rahmen darum ziehen.
Umschalt-Klick geht jederzeit.</translation>
    </message>
    <message>
        <source>Click the target in a camera image, or drag a box on it,
to learn its color again.</source>
        <translation>Das Ziel in einem Kamerabild anklicken oder einen Rahmen darauf ziehen,
um seine Farbe neu zu lernen.</translation>
    </message>
    <message>
        <source>Click another part of the target, or the target in different light.
Shift-click works at any time.</source>
        <translation>Eine andere Stelle des Ziels anklicken, oder das Ziel in anderem Licht.
Umschalt-Klick geht jederzeit.</translation>
    </message>
    <message>
        <source>Click something that matches but is not the target.
Alt-click or Ctrl+Shift-click works at any time.</source>
        <translation>Etwas anklicken, das auch passt, aber nicht das Ziel ist.
Alt-Klick oder Strg+Umschalt-Klick geht jederzeit.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LegendPicture</name>
    <message>
        <source>Cross: the estimate, the weighted mean of the particles.</source>
        <translation>Kreuz: die Schätzung, das gewichtete Mittel der Partikel.</translation>
    </message>
    <message>
        <source>Unbroken ellipse: with 95 % probability the target is inside. The smaller, the surer.</source>
        <translation>Durchgezogene Ellipse: Mit 95 % Wahrscheinlichkeit ist das Ziel darin. Je kleiner, desto sicherer.</translation>
    </message>
    <message>
        <source>Dashed ellipse: the size of the target itself, where it is not a ball.</source>
        <translation>Gestrichelte Ellipse: die Größe des Ziels selbst, wo es kein Ball ist.</translation>
    </message>
    <message>
        <source>White diamond: where the target really is. Only simulated scenes, such as the demo, know it.</source>
        <translation>Weiße Raute: wo das Ziel wirklich ist. Nur simulierte Szenen wie die Demo wissen es.</translation>
    </message>
    <message>
        <source>Triangle: the particle of highest weight (View › Show best particle).</source>
        <translation>Dreieck: das Partikel mit dem höchsten Gewicht (Ansicht › Bestes Partikel zeigen).</translation>
    </message>
    <message>
        <source>Line through the image: the ray of another camera along which the target must be, while you drag it to where it is.</source>
        <translation>Linie durch das Bild: der Strahl einer anderen Kamera, auf dem das Ziel sein muss, während Sie es dorthin ziehen, wo es ist.</translation>
    </message>
    <message>
        <source>Dots: particles. Each is one guess of where the target is; the brighter, the better it fits the images.</source>
        <translation>Punkte: Partikel. Jedes ist eine Vermutung, wo das Ziel ist; je heller, desto besser passt es zu den Bildern.</translation>
    </message>
    <message>
        <source>Tinted and outlined: where the image has the color of the target (View › Show mask).</source>
        <translation>Getönt und umrandet: wo das Bild die Farbe des Ziels hat (Ansicht › Maske zeigen).</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MainWindow</name>
    <message>
        <source>Dewpoint</source>
        <translation>Dewpoint</translation>
    </message>
    <message>
        <source>%1[*] – Dewpoint</source>
        <translation>%1[*] – Dewpoint</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibration</name>
    <message>
        <source>Three points are held already: click one of them to let go of it</source>
        <translation>Drei Punkte sind schon gehalten: ein Klick auf einen lässt ihn los</translation>
    </message>
    <message>
        <source>Drag the grid in %1</source>
        <translation>Gitter in %1 ziehen</translation>
    </message>
    <message>
        <source>No further: a point would leave what the camera can see</source>
        <translation>Nicht weiter: ein Punkt läge außerhalb dessen, was die Kamera sehen kann</translation>
    </message>
    <message>
        <source>No further: the held points and this one lie on one ray or line</source>
        <translation>Nicht weiter: die gehaltenen Punkte und dieser liegen auf einem Strahl oder einer Geraden</translation>
    </message>
    <message>
        <source>No further: no pose near this one shows the held points where they are</source>
        <translation>Nicht weiter: keine Pose in der Nähe zeigt die gehaltenen Punkte dort, wo sie sind</translation>
    </message>
    <message>
        <source>Three held points fix the pose: let go of one, or let the focal length change</source>
        <translation>Drei gehaltene Punkte legen die Pose fest: einen loslassen oder die Brennweite nachgeben lassen</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>aufwärts</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>%1 focal length %2 %</source>
        <translation>%1 Brennweite %2 %</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibrationPage</name>
    <message>
        <source>Drag the grid in an image until it lies on the real thing. Click a point of it to hold it there.</source>
        <translation>Das Gitter in einem Bild ziehen, bis es auf dem Wirklichen liegt. Ein Klick auf einen Punkt hält ihn dort fest.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Reference grid</source>
        <translation>Bezugsgitter</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Gemessene Punkte</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualWindow</name>
    <message>
        <source>Manual – Dewpoint</source>
        <translation>Handbuch – Dewpoint</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Seiten des Handbuchs</translation>
    </message>
    <message>
        <source>Back to the page before</source>
        <translation>Zurück zur vorigen Seite</translation>
    </message>
    <message>
        <source>Forward again</source>
        <translation>Wieder vorwärts</translation>
    </message>
    <message>
        <source>The manual was not found. It is expected in the folder %1.</source>
        <translation>Das Handbuch wurde nicht gefunden. Es wird im Ordner %1 erwartet.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MarkerEditor</name>
    <message>
        <source>Name of the mark</source>
        <translation>Name der Marke</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>Add a mark</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Remove a mark</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Rename a mark</source>
        <translation>Marke umbenennen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageRow</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MissingFilesOffer</name>
    <message>
        <source>%1 was not found in %2.</source>
        <translation>%1 wurde in %2 nicht gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n files of this project were not found: %1.</source>
        <translation>
            <numerusform>%n Datei dieses Projekts wurde nicht gefunden: %1.</numerusform>
            <numerusform>%n Dateien dieses Projekts wurden nicht gefunden: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>Suchen…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Opened with the located files. Save the project to keep where they are.</source>
        <translation>Mit den wiedergefundenen Dateien geöffnet. Speichern Sie das Projekt, um zu behalten, wo sie sind.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a file, the name of its camera</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::NewProjectPage</name>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>Videodateien, eine je Kamera</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>Ein Ordner mit Bildern, eines je Zeitpunkt</translation>
    </message>
    <message>
        <source>All cameras connected to this computer</source>
        <translation>Alle an diesen Rechner angeschlossenen Kameras</translation>
    </message>
    <message>
        <source>A device number or a network stream; type it in</source>
        <translation>Eine Gerätenummer oder ein Netzwerkstrom; zum Eintippen</translation>
    </message>
    <message>
        <source>Take the chosen cameras out</source>
        <translation>Die gewählten Kameras herausnehmen</translation>
    </message>
    <message>
        <source>Make the project and show its first images</source>
        <translation>Das Projekt machen und seine ersten Bilder zeigen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Back without making a project</source>
        <translation>Zurück, ohne ein Projekt zu machen</translation>
    </message>
    <message>
        <source>Name of the project</source>
        <translation>Name des Projekts</translation>
    </message>
    <message>
        <source>Rate of image folders, 0.1 to 10,000 per second</source>
        <translation>Bildrate von Bilderordnern, 0,1 bis 10.000 je Sekunde</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Images from</source>
        <translation>Bilder aus</translation>
    </message>
    <message>
        <source>Cameras of the new project</source>
        <translation>Kameras des neuen Projekts</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>Ein Video je Kamera wählen</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Einen Ordner mit Bildern wählen</translation>
    </message>
    <message>
        <source>No camera is connected to this computer. A network camera can be added by its address.</source>
        <translation>An diesen Rechner ist keine Kamera angeschlossen. Eine Netzwerkkamera lässt sich mit ihrer Adresse hinzufügen.</translation>
    </message>
    <message>
        <source>Without a calibration the camera positions are a guess: images can be tracked, but positions in space mean nothing yet.</source>
        <translation>Ohne Kalibrierung sind die Kamerapositionen geraten: In den Bildern lässt sich verfolgen, aber Positionen im Raum bedeuten noch nichts.</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>Die Kalibrierung nennt ihre Kameras anders: Sie wurden in ihrer Reihenfolge genommen.</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>Videos hinzufügen…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>Bilderordner hinzufügen…</translation>
    </message>
    <message>
        <source>Add connected cameras</source>
        <translation>Angeschlossene Kameras hinzufügen</translation>
    </message>
    <message>
        <source>Add address</source>
        <translation>Adresse hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Erstellen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Images per second:</source>
        <translation>Bilder je Sekunde:</translation>
    </message>
    <message>
        <source>Neither a video, nor images, nor a calibration: %1.</source>
        <translation>Weder ein Video noch Bilder noch eine Kalibrierung: %1.</translation>
    </message>
    <message>
        <source>One row per camera. Videos must be synchronized: frame N shows the same moment in all of them.</source>
        <translation>Eine Zeile je Kamera. Videos müssen synchronisiert sein: Bild N zeigt in allen denselben Moment.</translation>
    </message>
    <message>
        <source>(folder name)</source>
        <translation>(Name des Ordners)</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OldResultsOffer</name>
    <message>
        <source>Settings changed since this run.</source>
        <translation>Die Einstellungen haben sich seit diesem Lauf geändert.</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>Erneut verfolgen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OverlayLegend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>Legende der Einblendungen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ParameterPanel</name>
    <message>
        <source>The parameters appear here once a project is open.</source>
        <translation>Die Parameter erscheinen hier, sobald ein Projekt geöffnet ist.</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>Das Ding in einer Kameraansicht anklicken oder einen Rahmen darum ziehen.</translation>
    </message>
    <message>
        <source>This method works in the room: calibrate the cameras first (menu Calibration), their positions are only a guess.</source>
        <translation>Dieses Verfahren arbeitet im Raum: Zuerst die Kameras kalibrieren (Menü Kalibrierung), ihre Orte sind nur geraten.</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>More than “%1”: %2 is used.</source>
        <translation>Mehr als „%1“: Verwendet wird %2.</translation>
    </message>
    <message>
        <source>Less than “%1”, which has no effect then.</source>
        <translation>Weniger als „%1“, das dann nicht wirkt.</translation>
    </message>
    <message>
        <source>How the targets are tracked. Another method starts again; the rest stays.</source>
        <translation>Wie die Ziele verfolgt werden. Ein anderes Verfahren beginnt neu; der Rest bleibt.</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Give all parameters of this method their defaults</source>
        <translation>Allen Parametern dieses Verfahrens ihre Vorgaben geben</translation>
    </message>
    <message>
        <source>Volume of interest</source>
        <translation>Suchraum</translation>
    </message>
    <message>
        <source>Targets are searched for in a box alone.</source>
        <translation>Ziele werden nur in einem Quader gesucht.</translation>
    </message>
    <message>
        <source>Something here differs from its default.</source>
        <translation>Hier weicht etwas von seiner Vorgabe ab.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeopleDock</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Click somebody in a camera image, or the floor in the bird&apos;s-eye view. Esc ends it.</source>
        <translation>Jemanden in einem Kamerabild oder den Boden in der Vogelperspektive anklicken. Esc beendet es.</translation>
    </message>
    <message>
        <source>Folder for the tables of people</source>
        <translation>Ordner für die Tabellen der Personen</translation>
    </message>
    <message>
        <source>There are tables of another run in %1. Replace them?</source>
        <translation>In %1 liegen Tabellen eines anderen Laufs. Ersetzen?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>That run is over; the tables of its people were not written.</source>
        <translation>Dieser Lauf ist vorbei; die Tabellen seiner Personen wurden nicht geschrieben.</translation>
    </message>
    <message>
        <source>Places, volumes, hulls and densities of people are in %1 (frames: %2).</source>
        <translation>Orte, Volumen, Hüllen und Dichten der Personen liegen in %1 (Bilder: %2).</translation>
    </message>
    <message>
        <source>Writing the tables of people…</source>
        <translation>Die Tabellen der Personen werden geschrieben…</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Remove a person</source>
        <translation>Person entfernen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeoplePanel</name>
    <message>
        <source>People who are there</source>
        <translation>Anwesende Personen</translation>
    </message>
    <message>
        <source>How much of the empty room is learned</source>
        <translation>Wie viel vom leeren Raum gelernt ist</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Number of the person, which nobody else gets in this run</source>
        <translation>Nummer der Person, die in diesem Lauf niemand sonst bekommt</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Place in the room, x and y in meters</source>
        <translation>Ort im Raum, x und y in Metern</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Estimated height, meters; empty: the method does not estimate it</source>
        <translation>Geschätzte Größe, Meter; leer: Das Verfahren schätzt sie nicht</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Meters per second over the floor</source>
        <translation>Meter je Sekunde über dem Boden</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <source>Cameras that see the person, of all</source>
        <translation>Kameras, die die Person sehen, von allen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume of the hull that holds 95 % of the person, cubic meters; empty while hulls are not shown</source>
        <translation>Volumen der Hülle, die 95 % der Person enthält, Kubikmeter; leer, solange keine Hüllen gezeigt werden</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>How long the person has been there, seconds</source>
        <translation>Wie lange die Person da ist, Sekunden</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Somebody else is so near that colors are not learned</source>
        <translation>Jemand anderes ist so nah, dass Farben nicht gelernt werden</translation>
    </message>
    <message>
        <source>Learning the empty room: %1 %. Keep out of view.</source>
        <translation>Der leere Raum wird gelernt: %1 %. Bitte nicht ins Bild treten.</translation>
    </message>
    <message>
        <source>Nobody is there. People appear when two cameras see them.</source>
        <translation>Niemand ist da. Personen erscheinen, wenn zwei Kameras sie sehen.</translation>
    </message>
    <message>
        <source>People there: %1</source>
        <translation>Personen da: %1</translation>
    </message>
    <message>
        <source>People appear here once a method for people runs.</source>
        <translation>Personen erscheinen hier, sobald ein Verfahren für Personen läuft.</translation>
    </message>
    <message>
        <source>Somebody is near</source>
        <translation>Jemand ist nah</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlanPage</name>
    <message>
        <source>How well will these cameras measure, and where would one more help? Drag a camera in the bird&apos;s-eye view: the map follows.</source>
        <translation>Wie gut werden diese Kameras messen, und wo hülfe eine weitere? Eine Kamera in der Vogelperspektive ziehen: die Karte folgt.</translation>
    </message>
    <message>
        <source>Map of expected errors</source>
        <translation>Karte der erwarteten Fehler</translation>
    </message>
    <message>
        <source>Planned cameras</source>
        <translation>Geplante Kameras</translation>
    </message>
    <message>
        <source>Planned cameras are neither saved with the project nor part of the run. The map takes nothing in the room into account that hides a place.</source>
        <translation>Geplante Kameras werden nicht mit dem Projekt gespeichert und gehören nicht zum Lauf. Die Karte berücksichtigt nichts im Raum, was einen Ort verdeckt.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerForm</name>
    <message>
        <source>Add a camera to plan</source>
        <translation>Eine Kamera einplanen</translation>
    </message>
    <message>
        <source>A camera that is not there yet: drag it in the bird&apos;s-eye view, or type where it stands (%1)</source>
        <translation>Eine Kamera, die es noch nicht gibt: in der Vogelperspektive ziehen oder ihren Ort eingeben (%1)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the planned camera</source>
        <translation>Die geplante Kamera entfernen</translation>
    </message>
    <message>
        <source>Take the chosen planned camera away</source>
        <translation>Die gewählte geplante Kamera wegnehmen</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>Geplante Kamera</translation>
    </message>
    <message>
        <source>The planned camera that the numbers below belong to</source>
        <translation>Die geplante Kamera, zu der die Zahlen darunter gehören</translation>
    </message>
    <message>
        <source>Stands at x, y, z</source>
        <translation>Steht bei x, y, z</translation>
    </message>
    <message>
        <source>Looks at x, y, z</source>
        <translation>Blickt auf x, y, z</translation>
    </message>
    <message>
        <source>Field of view, image width and height</source>
        <translation>Blickwinkel, Bildbreite und -höhe</translation>
    </message>
    <message>
        <source>Planned position %1</source>
        <translation>Geplanter Ort %1</translation>
    </message>
    <message>
        <source>Where the camera stands, in meters</source>
        <translation>Wo die Kamera steht, in Metern</translation>
    </message>
    <message>
        <source>Planned camera looks at %1</source>
        <translation>Geplante Kamera blickt auf %1</translation>
    </message>
    <message>
        <source>A point on its line of sight, in meters</source>
        <translation>Ein Punkt auf ihrer Blickrichtung, in Metern</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Blickwinkel</translation>
    </message>
    <message>
        <source>How wide the camera sees, from left to right</source>
        <translation>Wie weit die Kamera sieht, von links nach rechts</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>Bildbreite</translation>
    </message>
    <message>
        <source>Pixels of its image, from left to right</source>
        <translation>Pixel ihres Bildes, von links nach rechts</translation>
    </message>
    <message>
        <source>Image height</source>
        <translation>Bildhöhe</translation>
    </message>
    <message>
        <source>Pixels of its image, from top to bottom</source>
        <translation>Pixel ihres Bildes, von oben nach unten</translation>
    </message>
    <message>
        <source>Walls and ceiling outside the volume by</source>
        <translation>Wände und Decke außerhalb des Raums um</translation>
    </message>
    <message>
        <source>Distance of the walls</source>
        <translation>Abstand der Wände</translation>
    </message>
    <message>
        <source>The search looks on the four walls and the ceiling around the volume, this far outside of it</source>
        <translation>Gesucht wird an den vier Wänden und der Decke um den Raum, so weit außerhalb</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Die Suche abbrechen</translation>
    </message>
    <message>
        <source>End the search; nothing is added</source>
        <translation>Die Suche beenden; nichts wird hinzugefügt</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>keine gewählt</translation>
    </message>
    <message>
        <source>Find the best place for %1</source>
        <translation>Den besten Ort für %1 suchen</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the place from which one more camera helps most (%1)</source>
        <translation>An Wänden und Decke den Ort suchen, von dem eine weitere Kamera am meisten hilft (%1)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerInstaller</name>
    <message>
        <source>Move %1 in the bird&apos;s-eye view</source>
        <translation>%1 in der Vogelperspektive verschieben</translation>
    </message>
    <message>
        <source>Turn %1 in the bird&apos;s-eye view</source>
        <translation>%1 in der Vogelperspektive drehen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotPanel</name>
    <message>
        <source>Plots of the run</source>
        <translation>Kurven des Laufs</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Choose the plots shown; copy or save them</source>
        <translation>Gezeigte Kurven wählen; kopieren oder speichern</translation>
    </message>
    <message>
        <source>Choose the plots shown</source>
        <translation>Gezeigte Kurven wählen</translation>
    </message>
    <message>
        <source>The plots are on the clipboard as CSV.</source>
        <translation>Die Kurven sind als CSV in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>Kurven speichern</translation>
    </message>
    <message>
        <source>Drawings (*.svg);;Pictures (*.png)</source>
        <translation>Zeichnungen (*.svg);;Bilder (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Plots appear when tracking runs.</source>
        <translation>Kurven erscheinen, sobald die Verfolgung läuft.</translation>
    </message>
    <message>
        <source>The target whose numbers are plotted: the one selected in Target, or the first.</source>
        <translation>Das Ziel, dessen Zahlen gezeigt werden: das unter „Ziel“ gewählte oder das erste.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotStack</name>
    <message>
        <source>frame %1, iteration %2, %3</source>
        <translation>Bild %1, Iteration %2, %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointCalibrator</name>
    <message>
        <source>%1 is rotated and mirrored: turn its images clockwise by %2 degrees, then mirror them</source>
        <translation>%1 ist gedreht und gespiegelt: ihre Bilder um %2 Grad im Uhrzeigersinn drehen, dann spiegeln</translation>
    </message>
    <message>
        <source>%1 is mirrored</source>
        <translation>%1 ist gespiegelt</translation>
    </message>
    <message>
        <source>%1 is rotated: turn its images clockwise by %2 degrees</source>
        <translation>%1 ist gedreht: ihre Bilder um %2 Grad im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Add measured point</source>
        <translation>Gemessenen Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove measured point</source>
        <translation>Gemessenen Punkt entfernen</translation>
    </message>
    <message>
        <source>Rename measured point</source>
        <translation>Gemessenen Punkt umbenennen</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Ort von %1</translation>
    </message>
    <message>
        <source>Click %1 in %2</source>
        <translation>%1 in %2 anklicken</translation>
    </message>
    <message>
        <source>Forget %1 in %2</source>
        <translation>%1 in %2 vergessen</translation>
    </message>
    <message>
        <source>Solve cameras from measured points</source>
        <translation>Kameras aus gemessenen Punkten bestimmen</translation>
    </message>
    <message>
        <source>No point was clicked yet: choose one, then click it in the images</source>
        <translation>Noch kein Punkt wurde angeklickt: einen wählen, dann in den Bildern anklicken</translation>
    </message>
    <message>
        <source>%1: %2 off on average</source>
        <translation>%1: im Mittel %2 daneben</translation>
    </message>
    <message>
        <source>%1: %2 points are too few, click four or more</source>
        <translation>%1: %2 Punkte sind zu wenige, vier oder mehr anklicken</translation>
    </message>
    <message>
        <source>%1: its points lie on one line, add one beside it</source>
        <translation>%1: ihre Punkte liegen auf einer Geraden, einen daneben hinzufügen</translation>
    </message>
    <message>
        <source>%1: %2, but a second pose fits as well: add a point outside the plane</source>
        <translation>%1: %2, aber eine zweite Pose passt ebenso gut: einen Punkt außerhalb der Ebene hinzufügen</translation>
    </message>
    <message>
        <source>%1: no pose shows the points there</source>
        <translation>%1: keine Pose zeigt die Punkte dort</translation>
    </message>
    <message>
        <source>%1, unless it was mounted so</source>
        <translation>%1, falls sie nicht so montiert ist</translation>
    </message>
    <message>
        <source>%1: then its points fit to %2</source>
        <translation>%1: dann passen ihre Punkte auf %2</translation>
    </message>
    <message>
        <source>%1 does not fit the rest (%2, %3): measure or click it again</source>
        <translation>%1 passt nicht zum Rest (%2, %3): neu messen oder neu anklicken</translation>
    </message>
    <message>
        <source>Worst: %1 (%2, %3)</source>
        <translation>Am schlechtesten: %1 (%2, %3)</translation>
    </message>
    <message>
        <source>Set how %1 lies</source>
        <translation>Lage der Bilder von %1 setzen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointsTable</name>
    <message>
        <source>Measured points</source>
        <translation>Gemessene Punkte</translation>
    </message>
    <message>
        <source>Places measured with a tape, in meters: double click to type. A marked row fits worst.</source>
        <translation>Mit dem Maßband gemessene Orte, in Metern: Doppelklick zum Eingeben. Die markierte Zeile passt am schlechtesten.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>x m</source>
        <translation>x m</translation>
    </message>
    <message>
        <source>y m</source>
        <translation>y m</translation>
    </message>
    <message>
        <source>z m</source>
        <translation>z m</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add a place of the room that you measured</source>
        <translation>Einen Ort des Raumes hinzufügen, der gemessen wurde</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen point</source>
        <translation>Den gewählten Punkt entfernen</translation>
    </message>
    <message>
        <source>Click in images</source>
        <translation>In Bildern anklicken</translation>
    </message>
    <message>
        <source>Then click the chosen point in every image that shows it: corners are found to a fraction of a pixel (Alt: exactly where you click). Esc ends it.</source>
        <translation>Dann den gewählten Punkt in jedem Bild anklicken, das ihn zeigt: Ecken werden auf Bruchteile eines Pixels gefunden (Alt: genau wo geklickt wird). Esc beendet es.</translation>
    </message>
    <message>
        <source>Forget click</source>
        <translation>Klick vergessen</translation>
    </message>
    <message>
        <source>Forget the click of this point in the chosen camera</source>
        <translation>Den Klick dieses Punktes in der gewählten Kamera vergessen</translation>
    </message>
    <message>
        <source>Solve focal lengths too</source>
        <translation>Auch Brennweiten bestimmen</translation>
    </message>
    <message>
        <source>For cameras with six points or more</source>
        <translation>Für Kameras mit sechs oder mehr Punkten</translation>
    </message>
    <message>
        <source>Solve cameras</source>
        <translation>Kameras bestimmen</translation>
    </message>
    <message>
        <source>Find the poses of all cameras in which points were clicked; four points or more each</source>
        <translation>Die Posen aller Kameras finden, in denen Punkte angeklickt wurden; je vier oder mehr</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>Set it: %1</source>
        <translation>Setzen: %1</translation>
    </message>
    <message>
        <source>Turn or mirror the images of this camera so, and solve again</source>
        <translation>Die Bilder dieser Kamera so drehen oder spiegeln und neu bestimmen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PreviewPane</name>
    <message>
        <source>Working on the preview: %1 %</source>
        <translation>Vorschau in Arbeit: %1 %</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>Erste Zeilen der Datei</translation>
    </message>
    <message>
        <source>Units and axes</source>
        <translation>Einheiten und Achsen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Some of these results are of earlier settings.</source>
        <translation>Einige dieser Ergebnisse stammen von früheren Einstellungen.</translation>
    </message>
    <message>
        <source>The preview was stopped. The next change begins it anew.</source>
        <translation>Die Vorschau wurde angehalten. Die nächste Änderung beginnt sie neu.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProblemReport</name>
    <message>
        <source>Report a problem – Dewpoint</source>
        <translation>Problem melden – Dewpoint</translation>
    </message>
    <message>
        <source>Write to those who gave you Dewpoint: what you did, what you expected, and what happened instead. Add the text below, and, if you can, the project file and a screenshot. Nothing is sent by itself.</source>
        <translation>Schreiben Sie denen, von denen Sie Dewpoint haben: was Sie getan haben, was Sie erwartet haben und was stattdessen geschah. Fügen Sie den Text unten hinzu und, wenn möglich, die Projektdatei und ein Bildschirmfoto. Von selbst wird nichts gesendet.</translation>
    </message>
    <message>
        <source>Text for the report</source>
        <translation>Text für die Meldung</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the text, to be pasted into a mail or a form</source>
        <translation>Den Text kopieren, zum Einfügen in eine Mail oder ein Formular</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectController</name>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>Das Ding in einer Kameraansicht anklicken oder einen Rahmen darum ziehen.</translation>
    </message>
    <message>
        <source>Click the thing to follow in any image: its color is learned and tracking starts.</source>
        <translation>Klicken Sie in irgendeinem Bild auf das, was verfolgt werden soll: Seine Farbe wird gelernt, und die Verfolgung beginnt.</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ein Projekt öffnen</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml);;All files (*)</source>
        <translation>Dewpoint-Projekte (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Recovered. Save the project to keep it.</source>
        <translation>Wiederhergestellt. Speichern Sie das Projekt, um es zu behalten.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::QuickStart</name>
    <message>
        <source>The cameras confirm where the target is.</source>
        <translation>Die Kameras bestätigen, wo das Ziel ist.</translation>
    </message>
    <message>
        <source>Something else fits about as well. Press X and drag the target to where it is.</source>
        <translation>Etwas anderes passt etwa genauso gut. Drücken Sie X, und ziehen Sie das Ziel dorthin, wo es ist.</translation>
    </message>
    <message>
        <source>Not found yet, or not seen for less than a second.</source>
        <translation>Noch nicht gefunden, oder seit weniger als einer Sekunde nicht gesehen.</translation>
    </message>
    <message>
        <source>Not seen for a second. The line at the bottom says why.</source>
        <translation>Seit einer Sekunde nicht gesehen. Die Zeile unten sagt, warum.</translation>
    </message>
    <message>
        <source>Quick start – Dewpoint</source>
        <translation>Schnelleinstieg – Dewpoint</translation>
    </message>
    <message>
        <source>What you see</source>
        <translation>Was Sie sehen</translation>
    </message>
    <message>
        <source>Each camera view shows its image, and over it what the program believes. The bird&apos;s-eye view shows the same in the room.</source>
        <translation>Jede Kameraansicht zeigt ihr Bild und darüber, was das Programm glaubt. Die Vogelperspektive zeigt dasselbe im Raum.</translation>
    </message>
    <message>
        <source>How sure it is</source>
        <translation>Wie sicher es ist</translation>
    </message>
    <message>
        <source>How to begin</source>
        <translation>Wie Sie beginnen</translation>
    </message>
    <message>
        <source>1.  Open one video per camera, or connect cameras: File › New project (%1). Or try the demo first.</source>
        <translation>1.  Öffnen Sie ein Video je Kamera, oder schließen Sie Kameras an: Datei › Neues Projekt (%1). Oder probieren Sie zuerst die Demo aus.</translation>
    </message>
    <message>
        <source>2.  Give the calibration of the cameras, or make one: menu Calibration (%1 to begin by hand). Without it, targets are tracked in the images only.</source>
        <translation>2.  Geben Sie die Kalibrierung der Kameras an, oder machen Sie eine: Menü Kalibrierung (%1 beginnt von Hand). Ohne sie werden Ziele nur in den Bildern verfolgt.</translation>
    </message>
    <message>
        <source>3.  Click the thing to follow in any image. Its color is learned in all cameras, and tracking starts.</source>
        <translation>3.  Klicken Sie in irgendeinem Bild das Ding an, das verfolgt werden soll. Seine Farbe wird in allen Kameras gelernt, und die Verfolgung beginnt.</translation>
    </message>
    <message>
        <source>4.  Press %1 to play and to pause. Drag along the timeline to look back: every view shows that frame as it was.</source>
        <translation>4.  %1 spielt ab und hält an. Ziehen Sie auf der Zeitleiste, um zurückzublicken: Jede Ansicht zeigt das Bild, wie es war.</translation>
    </message>
    <message>
        <source>5.  Export the trajectory: File › Export trajectory (%1).</source>
        <translation>5.  Exportieren Sie die Bahn: Datei › Bahn exportieren (%1).</translation>
    </message>
    <message>
        <source>All signs…</source>
        <translation>Alle Zeichen…</translation>
    </message>
    <message>
        <source>Open the legend of all that is drawn over the images</source>
        <translation>Die Legende von allem öffnen, was über die Bilder gezeichnet wird</translation>
    </message>
    <message>
        <source>Manual…</source>
        <translation>Handbuch…</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>Das Handbuch öffnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentList</name>
    <message>
        <source>The file is gone</source>
        <translation>Die Datei ist nicht mehr da</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentMenu</name>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Diese vergessen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecoveryOffer</name>
    <message>
        <source>Dewpoint did not end properly. Unsaved work on “%1” is from %2.</source>
        <translation>Dewpoint wurde nicht ordentlich beendet. Ungespeicherte Arbeit an „%1“ ist von %2.</translation>
    </message>
    <message>
        <source>Recover it</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Throw it away</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Unsaved work on “%1” was thrown away.</source>
        <translation>Ungespeicherte Arbeit an „%1“ wurde verworfen.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Zurückholen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RigPlanner</name>
    <message>
        <source>Put %1 here: x %2, y %3, z %4. Then %5 of the volume is within %6, instead of %7.</source>
        <translation>%1 hierher: x %2, y %3, z %4. Dann liegen %5 des Raums innerhalb von %6, statt %7.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunAlerts</name>
    <message>
        <source>No camera was bumped.</source>
        <translation>Keine Kamera wurde verdreht.</translation>
    </message>
    <message>
        <source>%1 cannot be solved again now.</source>
        <translation>%1 lässt sich jetzt nicht neu bestimmen.</translation>
    </message>
    <message>
        <source>Re-solve %1</source>
        <translation>%1 neu bestimmen</translation>
    </message>
    <message>
        <source>%1 is calibrated as it stands now. Undo takes it back.</source>
        <translation>%1 ist jetzt so kalibriert, wie sie steht. Rückgängig nimmt es zurück.</translation>
    </message>
    <message>
        <source>The target was %1 beside where the others see it, and is %2 now.</source>
        <translation>Das Ziel lag %1 neben dem, wo die anderen es sehen, jetzt %2.</translation>
    </message>
    <message>
        <source>Done: %1. Undo takes it back.</source>
        <translation>Erledigt: %1. „Rückgängig“ nimmt es zurück.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunDetails</name>
    <message>
        <source>median %1, 99 of 100 within %2, longest %3</source>
        <translation>Median %1, 99 von 100 innerhalb von %2, längste %3</translation>
    </message>
    <message>
        <source>none is set</source>
        <translation>keines festgelegt</translation>
    </message>
    <message>
        <source>%1, kept in %2 % of the iterations of this run</source>
        <translation>%1, in %2 % der Iterationen dieses Laufs eingehalten</translation>
    </message>
    <message>
        <source>Time per iteration, median</source>
        <translation>Zeit pro Iteration, Median</translation>
    </message>
    <message>
        <source>From a frame to its estimate</source>
        <translation>Vom Bild zu seiner Schätzung</translation>
    </message>
    <message>
        <source>Time budget per iteration</source>
        <translation>Zeitbudget pro Iteration</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>Effektive Stichprobengröße</translation>
    </message>
    <message>
        <source>Iterations since the start</source>
        <translation>Iterationen seit dem Start</translation>
    </message>
    <message>
        <source>Frames skipped</source>
        <translation>Übersprungene Bilder</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Kept of the past</source>
        <translation>Aufbewahrter Verlauf</translation>
    </message>
    <message>
        <source>%1 of %2 particles</source>
        <translation>%1 von %2 Partikeln</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 von %2 MB</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SessionController</name>
    <message>
        <source>Restart the run? What was tracked so far is lost.</source>
        <translation>Den Lauf neu beginnen? Was bisher verfolgt wurde, geht verloren.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Use image size</source>
        <translation>Größe der Bilder übernehmen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Aktionen suchen</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was sie tut</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>Aktionen und ihre Tastenkürzel</translation>
    </message>
    <message>
        <source>Click here and press the new keys of the chosen action</source>
        <translation>Hier klicken und die neuen Tasten der gewählten Aktion drücken</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Neues Tastenkürzel</translation>
    </message>
    <message>
        <source>No shortcut</source>
        <translation>Kein Tastenkürzel</translation>
    </message>
    <message>
        <source>Take the shortcut of the chosen action away</source>
        <translation>Der gewählten Aktion das Tastenkürzel nehmen</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>All shortcuts as they were at first</source>
        <translation>Alle Tastenkürzel wie am Anfang</translation>
    </message>
    <message>
        <source>Choose an action, click into the field below and press the new keys.</source>
        <translation>Eine Aktion wählen, in das Feld unten klicken und die neuen Tasten drücken.</translation>
    </message>
    <message>
        <source>“%1” has no shortcut now.</source>
        <translation>„%1“ hat jetzt kein Tastenkürzel.</translation>
    </message>
    <message>
        <source>All shortcuts are as they were at first.</source>
        <translation>Alle Tastenkürzel sind wie am Anfang.</translation>
    </message>
    <message>
        <source>“%1” is now %2.</source>
        <translation>„%1“ ist jetzt %2.</translation>
    </message>
    <message>
        <source>“%1” is now %2; “%3” has lost it.</source>
        <translation>„%1“ ist jetzt %2; „%3“ hat es verloren.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close; changed shortcuts are kept already</source>
        <translation>Schließen; geänderte Kürzel sind schon gespeichert</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SpeedButton</name>
    <message>
        <source>1/%1 ×</source>
        <comment>speed</comment>
        <translation>1/%1 ×</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <comment>speed</comment>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>How fast the recording is played. Live cameras are always tracked as they come.</source>
        <translation>Wie schnell die Aufnahme abgespielt wird. Livekameras werden immer so verfolgt, wie ihre Bilder kommen.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StartPage</name>
    <message>
        <source>Dewpoint</source>
        <translation>Dewpoint</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>Demo ausprobieren</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt geöffnete Projekte</translation>
    </message>
    <message>
        <source>You can also drop a project or videos onto this window.</source>
        <translation>Ein Projekt oder Videos lassen sich auch auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Watch it converge</source>
        <translation>Zusehen, wie es konvergiert</translation>
    </message>
    <message>
        <source>A cloud of guesses slides along a line of sight and snaps onto the ball.</source>
        <translation>Eine Wolke von Vermutungen gleitet eine Sichtlinie entlang und springt auf den Ball.</translation>
    </message>
    <message>
        <source>Hidden for a second</source>
        <translation>Eine Sekunde lang verdeckt</translation>
    </message>
    <message>
        <source>A box passes in front of the ball. One camera is enough to keep it.</source>
        <translation>Eine Kiste zieht vor dem Ball vorbei. Eine Kamera genügt, um ihn zu halten.</translation>
    </message>
    <message>
        <source>Three more balls of the same color lie around. Only one moves.</source>
        <translation>Drei weitere Bälle derselben Farbe liegen herum. Nur einer bewegt sich.</translation>
    </message>
    <message>
        <source>People in an office</source>
        <translation>Personen in einem Büro</translation>
    </message>
    <message>
        <source>Four cameras carve everybody out of space, and give each a number.</source>
        <translation>Vier Kameras schälen jede Person aus dem Raum heraus und geben ihr eine Nummer.</translation>
    </message>
    <message>
        <source>One camera and a box</source>
        <translation>Eine Kamera und ein Rahmen</translation>
    </message>
    <message>
        <source>No calibration: a box in the image is followed by its colors.</source>
        <translation>Keine Kalibrierung: Ein Rahmen im Bild wird anhand seiner Farben verfolgt.</translation>
    </message>
    <message>
        <source>Calibrate by hand</source>
        <translation>Von Hand kalibrieren</translation>
    </message>
    <message>
        <source>Drag a grid over the images until it lies on the floor.</source>
        <translation>Ein Gitter über die Bilder ziehen, bis es auf dem Boden liegt.</translation>
    </message>
    <message>
        <source>Follow colored objects in 3D with ordinary cameras.</source>
        <translation>Farbige Objekte mit gewöhnlichen Kameras in 3D verfolgen.</translation>
    </message>
    <message>
        <source>Two simulated cameras see a pink ball; a particle filter finds it and follows it through space. Pause, look back, change everything: nothing can break.</source>
        <translation>Zwei simulierte Kameras sehen einen rosa Ball; ein Partikelfilter findet ihn und verfolgt ihn durch den Raum. Anhalten, zurückblicken, alles ändern: Nichts kann kaputtgehen.</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Ihr Eigenes</translation>
    </message>
    <message>
        <source>Open videos…</source>
        <translation>Videos öffnen…</translation>
    </message>
    <message>
        <source>One recording per camera</source>
        <translation>Eine Aufnahme je Kamera</translation>
    </message>
    <message>
        <source>Use cameras…</source>
        <translation>Kameras verwenden…</translation>
    </message>
    <message>
        <source>Connected ones, or network streams</source>
        <translation>Angeschlossene oder Netzwerkströme</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>One that was saved before</source>
        <translation>Ein früher gespeichertes</translation>
    </message>
    <message>
        <source>Four balls alike</source>
        <translation>Vier gleiche Bälle</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StatusBarPanel</name>
    <message>
        <source>playing</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>am Ende</translation>
    </message>
    <message>
        <source>Frame shown, of all frames</source>
        <translation>Gezeigtes Bild, von allen Bildern</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Frames tracked per second</source>
        <translation>Verfolgte Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Estimated position of the target in the room</source>
        <translation>Geschätzte Position des Ziels im Raum</translation>
    </message>
    <message>
        <source>frame %1 / %2</source>
        <translation>Bild %1 / %2</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3</source>
        <translation>x %1  y %2  z %3</translation>
    </message>
    <message>
        <source>tracking again</source>
        <translation>verfolgt erneut</translation>
    </message>
    <message>
        <source>looking back</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>Playing, paused, at the end, looking back at an earlier moment, or tracking it again</source>
        <translation>Läuft, angehalten, am Ende, im Rückblick auf einen früheren Moment oder diesen erneut verfolgend</translation>
    </message>
    <message>
        <source>held where it is thought to be</source>
        <translation>gehalten, wo es vermutet wird</translation>
    </message>
    <message>
        <source>click it or drag a box around it</source>
        <translation>anklicken oder einen Rahmen darum ziehen</translation>
    </message>
    <message>
        <source>x %1  y %2  %3 × %4</source>
        <translation>x %1  y %2  %3 × %4</translation>
    </message>
    <message>
        <source>● people: %1</source>
        <translation>● Personen: %1</translation>
    </message>
    <message>
        <source>○ people: %1, searching</source>
        <translation>○ Personen: %1, sucht</translation>
    </message>
    <message>
        <source>others fit as well: press X, drag the target</source>
        <translation>anderes passt ebenso gut: X drücken, Ziel ziehen</translation>
    </message>
    <message>
        <source>Held: the cameras confirm the estimate. Ambiguous: something else fits about as well. Lost: not held for a second.</source>
        <translation>Gehalten: Die Kameras bestätigen die Schätzung. Mehrdeutig: Etwas anderes passt etwa genauso gut. Verloren: seit einer Sekunde nicht gehalten.</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>How exactly the position is known: the standard deviation in 3D, x, y and z together (the plots show each)</source>
        <translation>Wie genau die Position bekannt ist: die Standardabweichung in 3D, x, y und z zusammen (die Kurven zeigen sie einzeln)</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>Speed of the target in the room</source>
        <translation>Geschwindigkeit des Ziels im Raum</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Times, particles, and what is kept of the past</source>
        <translation>Zeiten, Partikel und der aufbewahrte Verlauf</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetPanel</name>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the target, in views and files</source>
        <translation>Name des Ziels, in Ansichten und Dateien</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Radius of the ball, 0 to 2,000 mm. Unknown: it is estimated.</source>
        <translation>Radius des Balls, 0 bis 2.000 mm. Unbekannt: Er wird geschätzt.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Ball: its outline is a circle in every image. Any: its extent is learned, and its center is that of its color. Automatic: the images decide. Only method dewpoint uses this.</source>
        <translation>Ball: Sein Umriss ist in jedem Bild ein Kreis. Beliebig: Die Ausdehnung wird gelernt, und der Mittelpunkt ist der seiner Farbe. Automatisch: Die Bilder entscheiden. Nur das Verfahren dewpoint verwendet dies.</translation>
    </message>
    <message>
        <source>No target yet: click the thing to follow in any camera image.</source>
        <translation>Noch kein Ziel: In einem Kamerabild auf das klicken, was verfolgt werden soll.</translation>
    </message>
    <message>
        <source>The color of a target is learned by clicking it in a camera image.</source>
        <translation>Die Farbe eines Ziels wird gelernt, wenn man es in einem Kamerabild anklickt.</translation>
    </message>
    <message>
        <source>Rename target</source>
        <translation>Ziel umbenennen</translation>
    </message>
    <message>
        <source>Change radius</source>
        <translation>Radius ändern</translation>
    </message>
    <message>
        <source>Change shape</source>
        <translation>Form ändern</translation>
    </message>
    <message>
        <source>Remove target</source>
        <translation>Ziel entfernen</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view: it is followed from there on.</source>
        <translation>Das Ding in einer Kameraansicht anklicken oder einen Rahmen darum ziehen: Von da an wird ihm gefolgt.</translation>
    </message>
    <message>
        <source>No box at this moment.</source>
        <translation>Zu diesem Zeitpunkt kein Rahmen.</translation>
    </message>
    <message>
        <source>%1, in %2
Center %3, %4, size %5 × %6
Similarity %7
Effective sample size %8 of %9</source>
        <translation>%1, in %2
Mitte %3, %4, Größe %5 × %6
Ähnlichkeit %7
Effektive Stichprobengröße %8 von %9</translation>
    </message>
    <message>
        <source>Spread %1</source>
        <translation>Streuung %1</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>Radius %1</translation>
    </message>
    <message>
        <source>radius %1 (found)</source>
        <translation>Radius %1 (gefunden)</translation>
    </message>
    <message>
        <source>radius unknown</source>
        <translation>Radius unbekannt</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Add target</source>
        <translation>Ziel hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ThreadCountDialog</name>
    <message>
        <source>Filter threads</source>
        <translation>Filter-Threads</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>as suits this machine</source>
        <translation>wie es zu diesem Rechner passt</translation>
    </message>
    <message>
        <source>How many threads share the work of the filter; results are the same with any number</source>
        <translation>Wie viele Threads sich die Arbeit des Filters teilen; die Ergebnisse sind mit jeder Anzahl dieselben</translation>
    </message>
    <message>
        <source>Used from the next frame on.</source>
        <translation>Gilt ab dem nächsten Bild.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Keep this number</source>
        <translation>Diese Anzahl übernehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Timeline</name>
    <message>
        <source>Memory for going back in the run: images, particles and copies of the method. When it is full, older moments keep their estimates only.</source>
        <translation>Speicher, um im Lauf zurückzugehen: Bilder, Partikel und Kopien des Verfahrens. Ist er voll, behalten ältere Momente nur ihre Schätzungen.</translation>
    </message>
    <message>
        <source>Nothing tracked yet: play (Space), then drag here through time.</source>
        <translation>Noch nichts verfolgt: abspielen (Leertaste), dann hier durch die Zeit ziehen.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>The change holds from now on. “%1” shows what it makes of this moment.</source>
        <translation>Die Änderung gilt ab jetzt. „%1“ zeigt, was sie aus diesem Moment macht.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TouchedInstantList</name>
    <message>
        <source>The ball %1</source>
        <translation>Der Ball %1</translation>
    </message>
    <message>
        <source>What the ball does at the moment</source>
        <translation>Was der Ball in dem Augenblick tut</translation>
    </message>
    <message>
        <source>Three places of the floor, or a fall, tell where up is</source>
        <translation>Drei Stellen des Bodens oder ein Fall sagen, wo oben ist</translation>
    </message>
    <message>
        <source>Take this moment</source>
        <translation>Diesen Augenblick nehmen</translation>
    </message>
    <message>
        <source>The moment that the images show is one at which the ball does this</source>
        <translation>In dem Augenblick, den die Bilder zeigen, tut der Ball dies</translation>
    </message>
    <message>
        <source>Remove moment</source>
        <translation>Augenblick entfernen</translation>
    </message>
    <message>
        <source>Take the chosen moment off the list</source>
        <translation>Den gewählten Augenblick aus der Liste nehmen</translation>
    </message>
    <message>
        <source>Moments taken</source>
        <translation>Genommene Augenblicke</translation>
    </message>
    <message>
        <source>Double click or Enter shows the moment</source>
        <translation>Doppelklick oder Eingabe zeigt den Augenblick</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryModel</name>
    <message>
        <source>● held</source>
        <translation>● gehalten</translation>
    </message>
    <message>
        <source>○ not held</source>
        <translation>○ nicht gehalten</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Seconds, of the frame</source>
        <translation>Sekunden, des Bildes</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>Bild, ab 1 gezählt</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Name des Ziels</translation>
    </message>
    <message>
        <source>%1, m</source>
        <translation>%1, m</translation>
    </message>
    <message>
        <source>Position in the room, meters</source>
        <translation>Ort im Raum, Meter</translation>
    </message>
    <message>
        <source>σ%1, mm</source>
        <translation>σ%1, mm</translation>
    </message>
    <message>
        <source>Standard deviation of the position, millimeters</source>
        <translation>Standardabweichung des Ortes, Millimeter</translation>
    </message>
    <message>
        <source>speed, m/s</source>
        <translation>Geschw., m/s</translation>
    </message>
    <message>
        <source>Speed, meters per second: fitted over five frames</source>
        <translation>Geschwindigkeit, Meter pro Sekunde: über fünf Bilder angepasst</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Cameras that see the target</source>
        <translation>Kameras, die das Ziel sehen</translation>
    </message>
    <message>
        <source>existence</source>
        <translation>Existenz</translation>
    </message>
    <message>
        <source>Probability that the target is where the estimate says</source>
        <translation>Wahrscheinlichkeit, dass das Ziel dort ist, wo die Schätzung sagt</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>◆ corrected</source>
        <translation>◆ korrigiert</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ mehrdeutig</translation>
    </message>
    <message>
        <source>Held: the cameras confirm the estimate. Ambiguous: something else fits about as well. Corrected: you said where the target is</source>
        <translation>Gehalten: Die Kameras bestätigen die Schätzung. Mehrdeutig: Etwas anderes passt etwa genauso gut. Korrigiert: Sie haben gesagt, wo das Ziel ist</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryPanel</name>
    <message>
        <source>Trajectory</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Speed and height over time</source>
        <translation>Geschwindigkeit und Höhe über die Zeit</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message numerus="yes">
        <source>%n rows are on the clipboard as CSV.</source>
        <translation>
            <numerusform>%n Zeile liegt als CSV in der Zwischenablage.</numerusform>
            <numerusform>%n Zeilen liegen als CSV in der Zwischenablage.</numerusform>
        </translation>
    </message>
    <message>
        <source>The trajectory appears here as soon as the target is tracked.</source>
        <translation>Die Bahn erscheint hier, sobald das Ziel verfolgt wird.</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n Messpunkt</numerusform>
            <numerusform>%n Messpunkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples, no gaps</source>
        <translation>
            <numerusform>%n Messpunkt, keine Lücken</numerusform>
            <numerusform>%n Messpunkte, keine Lücken</numerusform>
        </translation>
    </message>
    <message>
        <source>The boxes are on the clipboard as CSV.</source>
        <translation>Die Rahmen sind als CSV in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Remove the correction</source>
        <translation>Die Korrektur entfernen</translation>
    </message>
    <message>
        <source>Speed and height appear when tracking runs.</source>
        <translation>Geschwindigkeit und Höhe erscheinen, sobald die Verfolgung läuft.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::UncertaintyMapForm</name>
    <message>
        <source>Show the map in the bird&apos;s-eye view</source>
        <translation>Die Karte in der Vogelperspektive zeigen</translation>
    </message>
    <message>
        <source>How far off a target is expected to be at each place; it follows every move of a camera</source>
        <translation>Wie weit ein Ziel an jedem Ort voraussichtlich danebenliegt; folgt jeder Bewegung einer Kamera</translation>
    </message>
    <message>
        <source>Colors show</source>
        <translation>Farben zeigen</translation>
    </message>
    <message>
        <source>the expected error</source>
        <translation>den erwarteten Fehler</translation>
    </message>
    <message>
        <source>the number of cameras</source>
        <translation>die Zahl der Kameras</translation>
    </message>
    <message>
        <source>What the colors show</source>
        <translation>Was die Farben zeigen</translation>
    </message>
    <message>
        <source>The expected error (standard deviation along the worst direction), or how many cameras see a place</source>
        <translation>Der erwartete Fehler (Standardabweichung in der schlechtesten Richtung), oder wie viele Kameras einen Ort sehen</translation>
    </message>
    <message>
        <source>Good enough</source>
        <translation>Gut genug</translation>
    </message>
    <message>
        <source>The error that is good enough: up to it the map is blue, and it is what the sentence and the search for a place go by</source>
        <translation>Der Fehler, der gut genug ist: bis dahin ist die Karte blau, und danach richten sich der Satz und die Suche nach einem Ort</translation>
    </message>
    <message>
        <source>Error of a sighting</source>
        <translation>Fehler einer Sichtung</translation>
    </message>
    <message>
        <source>How far off a target is found in an image, in pixels (one standard deviation)</source>
        <translation>Wie weit daneben ein Ziel im Bild gefunden wird, in Pixeln (eine Standardabweichung)</translation>
    </message>
    <message>
        <source>Layer at</source>
        <translation>Schicht bei</translation>
    </message>
    <message>
        <source>Show the map in a horizontal layer</source>
        <translation>Die Karte in einer waagrechten Schicht zeigen</translation>
    </message>
    <message>
        <source>Height of the layer</source>
        <translation>Höhe der Schicht</translation>
    </message>
    <message>
        <source>Height of the layer above the floor</source>
        <translation>Höhe der Schicht über dem Boden</translation>
    </message>
    <message>
        <source>Height of the layer in meters</source>
        <translation>Höhe der Schicht in Metern</translation>
    </message>
    <message>
        <source>Volume: surfaces around what is good and what is fair</source>
        <translation>Raum: Flächen um Gutes und Brauchbares</translation>
    </message>
    <message>
        <source>Show through the room where the error is at most 0.4, 1 and 2 times what is good enough, or where two, three and four cameras see</source>
        <translation>Im ganzen Raum zeigen, wo der Fehler höchstens das 0,4-, 1- und 2-fache dessen ist, was gut genug ist, oder wo zwei, drei und vier Kameras sehen</translation>
    </message>
    <message>
        <source>Volume from x, y, z</source>
        <translation>Raum von x, y, z</translation>
    </message>
    <message>
        <source>to x, y, z</source>
        <translation>bis x, y, z</translation>
    </message>
    <message>
        <source>Volume from %1</source>
        <translation>Raum von %1</translation>
    </message>
    <message>
        <source>Where the volume begins, in meters</source>
        <translation>Wo der Raum beginnt, in Metern</translation>
    </message>
    <message>
        <source>Volume to %1</source>
        <translation>Raum bis %1</translation>
    </message>
    <message>
        <source>Where the volume ends, in meters</source>
        <translation>Wo der Raum endet, in Metern</translation>
    </message>
    <message>
        <source>Like the reference grid</source>
        <translation>Wie das Bezugsgitter</translation>
    </message>
    <message>
        <source>The volume above the reference grid, up to the highest camera</source>
        <translation>Der Raum über dem Bezugsgitter, bis zur höchsten Kamera</translation>
    </message>
    <message>
        <source>%1 of the volume within %2, %3 seen by fewer than two cameras</source>
        <translation>%1 des Raums innerhalb von %2, %3 von weniger als zwei Kameras gesehen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewButtons</name>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Look from above: X to the right, Y up. Drag to move, wheel to zoom, double click to see everything.</source>
        <translation>Blick von oben: X nach rechts, Y nach oben. Ziehen verschiebt, das Rad zoomt, ein Doppelklick zeigt alles.</translation>
    </message>
    <message>
        <source>Look from the front: X to the right, Z up. Drag to move, wheel to zoom, double click to see everything.</source>
        <translation>Blick von vorn: X nach rechts, Z nach oben. Ziehen verschiebt, das Rad zoomt, ein Doppelklick zeigt alles.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>See everything again, in the same view. Double click does it too.</source>
        <translation>Wieder alles sehen, in derselben Ansicht. Ein Doppelklick tut es auch.</translation>
    </message>
    <message>
        <source>Perspective view. Drag to orbit, Shift-drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Perspektive. Ziehen dreht, Umschalt und Ziehen verschiebt, das Rad zoomt, ein Doppelklick zeigt alles.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewPictures</name>
    <message>
        <source>Save picture as PNG…</source>
        <translation>Bild als PNG speichern…</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save a picture of %1</source>
        <translation>Ein Bild von %1 speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Saved the picture %1.</source>
        <translation>Das Bild %1 wurde gespeichert.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VolumeForm</name>
    <message>
        <source>From X, Y, Z</source>
        <translation>Von X, Y, Z</translation>
    </message>
    <message>
        <source>To X, Y, Z</source>
        <translation>Bis X, Y, Z</translation>
    </message>
    <message>
        <source>Volume of interest from %1</source>
        <translation>Suchraum von %1</translation>
    </message>
    <message>
        <source>Volume of interest to %1</source>
        <translation>Suchraum bis %1</translation>
    </message>
    <message>
        <source>Where the volume of interest begins, in meters; targets are searched for in it alone</source>
        <translation>Wo der Suchraum beginnt, in Metern; Ziele werden nur in ihm gesucht</translation>
    </message>
    <message>
        <source>Where the volume of interest ends, in meters; targets are searched for in it alone</source>
        <translation>Wo der Suchraum endet, in Metern; Ziele werden nur in ihm gesucht</translation>
    </message>
    <message>
        <source>From the cameras</source>
        <translation>Aus den Kameras</translation>
    </message>
    <message>
        <source>Search for targets in the box around what at least two cameras see</source>
        <translation>Ziele in dem Quader suchen, der umschließt, was mindestens zwei Kameras sehen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Search for targets anywhere</source>
        <translation>Ziele überall suchen</translation>
    </message>
    <message>
        <source>Set volume of interest</source>
        <translation>Suchraum festlegen</translation>
    </message>
    <message>
        <source>Remove volume of interest</source>
        <translation>Suchraum entfernen</translation>
    </message>
    <message>
        <source>Targets are searched for in this box alone.</source>
        <translation>Ziele werden nur in diesem Quader gesucht.</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. The numbers are what the cameras see; change one to search in a box.</source>
        <translation>Keiner: Ziele werden überall gesucht. Die Zahlen sind das, was die Kameras sehen; ändern Sie eine, um in einem Quader zu suchen.</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. Change a number to search in a box.</source>
        <translation>Keiner: Ziele werden überall gesucht. Ändern Sie eine Zahl, um in einem Quader zu suchen.</translation>
    </message>
    <message>
        <source>Change volume of interest</source>
        <translation>Suchraum ändern</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrationPage</name>
    <message>
        <source>Nudge the cameras by hand until they are roughly right. Then wave the ball, or a stick with two balls, through the whole volume, and refine.</source>
        <translation>Richten Sie die Kameras von Hand aus, bis sie ungefähr stimmen. Schwenken Sie dann den Ball oder einen Stab mit zwei Bällen durch den ganzen Raum, und verfeinern Sie.</translation>
    </message>
    <message>
        <source>Nudge the cameras by hand until they are roughly right. A recording of a ball, or a stick with two balls, waved through the whole volume then makes them exact.</source>
        <translation>Richten Sie die Kameras von Hand aus, bis sie ungefähr stimmen. Die Aufnahme eines Balls oder eines Stabs mit zwei Bällen, durch den ganzen Raum geschwenkt, macht sie dann genau.</translation>
    </message>
    <message>
        <source>Where the floor is</source>
        <translation>Wo der Boden ist</translation>
    </message>
    <message>
        <source>Waving</source>
        <translation>Schwenken</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>Schwenken</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrator</name>
    <message>
        <source>Press Start waving, and wave for half a minute where things are to be tracked.</source>
        <translation>Drücken Sie „Schwenken beginnen“, und schwenken Sie eine halbe Minute lang dort, wo verfolgt werden soll.</translation>
    </message>
    <message>
        <source>Refine cameras with a waved stick</source>
        <translation>Kameras mit geschwenktem Stab verfeinern</translation>
    </message>
    <message>
        <source>Refine cameras with a waved ball</source>
        <translation>Kameras mit geschwenktem Ball verfeinern</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandForm</name>
    <message>
        <source>the ball&apos;s diameter</source>
        <translation>dem Durchmesser des Balls</translation>
    </message>
    <message>
        <source>the ball&apos;s diameter, %1</source>
        <translation>dem Durchmesser des Balls, %1</translation>
    </message>
    <message>
        <source>the cameras as they are</source>
        <translation>den Kameras, wie sie sind</translation>
    </message>
    <message>
        <source>a distance touched</source>
        <translation>einer berührten Strecke</translation>
    </message>
    <message>
        <source>Waved</source>
        <translation>Geschwenkt</translation>
    </message>
    <message>
        <source>one ball</source>
        <translation>ein Ball</translation>
    </message>
    <message>
        <source>a stick with two balls</source>
        <translation>ein Stab mit zwei Bällen</translation>
    </message>
    <message>
        <source>What is waved</source>
        <translation>Was geschwenkt wird</translation>
    </message>
    <message>
        <source>A stick also gives the size, better than anything else</source>
        <translation>Ein Stab gibt auch die Größe, besser als alles andere</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>The target that is waved: its color is looked for</source>
        <translation>Das Ziel, das geschwenkt wird: seine Farbe wird gesucht</translation>
    </message>
    <message>
        <source>Second ball</source>
        <translation>Zweiter Ball</translation>
    </message>
    <message>
        <source>The target at the other end of the stick</source>
        <translation>Das Ziel am anderen Ende des Stabs</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the stick</source>
        <translation>Länge des Stabs</translation>
    </message>
    <message>
        <source>From the middle of one ball to that of the other</source>
        <translation>Von der Mitte des einen Balls zu der des anderen</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Size from</source>
        <translation>Größe von</translation>
    </message>
    <message>
        <source>What gives the size</source>
        <translation>Was die Größe gibt</translation>
    </message>
    <message>
        <source>Images alone do not tell a large room from a small one: a diameter is good to about one percent, a distance to what you measure</source>
        <translation>Bilder allein unterscheiden keinen großen Raum von einem kleinen: ein Durchmesser ist auf etwa ein Prozent gut, eine Strecke so gut, wie Sie messen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Distance touched</source>
        <translation>Berührte Strecke</translation>
    </message>
    <message>
        <source>Between the two places that the middle of the ball was held at</source>
        <translation>Zwischen den beiden Orten, an die die Mitte des Balls gehalten wurde</translation>
    </message>
    <message>
        <source>Off by up to</source>
        <translation>Daneben um bis zu</translation>
    </message>
    <message>
        <source>How far cameras may be off</source>
        <translation>Wie weit Kameras daneben sein können</translation>
    </message>
    <message>
        <source>How well the cameras are nudged: about how far each may be from its true place</source>
        <translation>Wie gut die Kameras ausgerichtet sind: etwa wie weit jede von ihrem wahren Ort sein kann</translation>
    </message>
    <message>
        <source>How much cameras may be turned</source>
        <translation>Wie weit Kameras verdreht sein können</translation>
    </message>
    <message>
        <source>About how far each may be turned from where it truly looks</source>
        <translation>Etwa wie weit jede von ihrer wahren Blickrichtung verdreht sein kann</translation>
    </message>
    <message>
        <source>Find time offsets</source>
        <translation>Zeitversätze suchen</translation>
    </message>
    <message>
        <source>For cameras that do not take their images at the same instants</source>
        <translation>Für Kameras, die ihre Bilder nicht gleichzeitig aufnehmen</translation>
    </message>
    <message>
        <source>Find focal lengths</source>
        <translation>Brennweiten suchen</translation>
    </message>
    <message>
        <source>For lenses that were never calibrated, or zoomed</source>
        <translation>Für Objektive, die nie kalibriert oder gezoomt wurden</translation>
    </message>
    <message>
        <source>Find the distortion k1</source>
        <translation>Die Verzeichnung k1 suchen</translation>
    </message>
    <message>
        <source>The first coefficient of each lens; needs a ball seen up to the edges of the images</source>
        <translation>Der erste Koeffizient jedes Objektivs; dazu muss der Ball bis an die Bildränder gesehen werden</translation>
    </message>
    <message>
        <source>Only the selected span</source>
        <translation>Nur der ausgewählte Abschnitt</translation>
    </message>
    <message>
        <source>Look through the stretch selected in the timeline, not the whole recording</source>
        <translation>Den in der Zeitleiste ausgewählten Abschnitt durchsehen, nicht die ganze Aufnahme</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandOutcome</name>
    <message>
        <source>Refine cameras</source>
        <translation>Kameras verfeinern</translation>
    </message>
    <message>
        <source>Find the ball in all images, and the cameras that explain them best</source>
        <translation>Den Ball in allen Bildern finden, und die Kameras, die sie am besten erklären</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop; the cameras stay as they are</source>
        <translation>Anhalten; die Kameras bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>While it is pressed, the grid is drawn with the cameras as they were</source>
        <translation>Solange gedrückt, wird das Gitter mit den Kameras gezeichnet, wie sie waren</translation>
    </message>
    <message>
        <source>Use it anyway</source>
        <translation>Trotzdem verwenden</translation>
    </message>
    <message>
        <source>Take these cameras although something seems to be wrong; it can be undone</source>
        <translation>Diese Kameras nehmen, obwohl etwas nicht zu stimmen scheint; das lässt sich zurücknehmen</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>A page with all figures, residuals as arrows, coverage and a drawing in space</source>
        <translation>Eine Seite mit allen Zahlen, Residuen als Pfeilen, Abdeckung und einer Zeichnung im Raum</translation>
    </message>
    <message>
        <source>Cameras found</source>
        <translation>Gefundene Kameras</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>moved cm</source>
        <translation>bewegt cm</translation>
    </message>
    <message>
        <source>turned °</source>
        <translation>gedreht °</translation>
    </message>
    <message>
        <source>late ms</source>
        <translation>spät ms</translation>
    </message>
    <message>
        <source>Root mean square distance between seen and projected balls</source>
        <translation>Quadratisches Mittel der Abstände zwischen gesehenen und projizierten Bällen</translation>
    </message>
    <message>
        <source>How far the camera is from where it was</source>
        <translation>Wie weit die Kamera von da ist, wo sie war</translation>
    </message>
    <message>
        <source>How far it is turned from where it looked</source>
        <translation>Wie weit sie von ihrer früheren Blickrichtung gedreht ist</translation>
    </message>
    <message>
        <source>The cameras are as they were.</source>
        <translation>Die Kameras sind, wie sie waren.</translation>
    </message>
    <message>
        <source>Solutions without a part of the recording differ %1 times more than noise explains; the verdict includes that.</source>
        <translation>Lösungen ohne einen Teil der Aufnahme weichen %1-mal mehr ab, als Rauschen erklärt; das Urteil enthält das.</translation>
    </message>
    <message>
        <source>The fall says %1 m/s² (9.81 is expected).</source>
        <translation>Der Fall sagt %1 m/s² (9,81 wird erwartet).</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>What was found of each camera; point at a heading to see what it means</source>
        <translation>Was über jede Kamera gefunden wurde; zeige auf eine Überschrift, um zu sehen, was sie bedeutet</translation>
    </message>
    <message>
        <source>The cameras were changed since; this is about how they were refined.</source>
        <translation>Die Kameras wurden seither geändert; dies gilt für den Stand nach dem Verfeinern.</translation>
    </message>
    <message>
        <source>By how much its images are later than the first camera&apos;s, beyond what was known</source>
        <translation>Um wie viel ihre Bilder später sind als die der ersten Kamera, über das Bekannte hinaus</translation>
    </message>
    <message>
        <source>That is less sure than the cameras were (off by up to %1): wave through more of the volume.</source>
        <translation>Das ist unsicherer, als die Kameras waren (bis zu %1 daneben): Schwenken Sie durch mehr vom Raum.</translation>
    </message>
    <message>
        <source>How late cameras are is kept in the project: images are put together by it from now on.</source>
        <translation>Wie sehr Kameras verspätet sind, steht nun im Projekt: Bilder werden ab jetzt danach zusammengestellt.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandWaving</name>
    <message>
        <source>Collect where every camera sees the ball; beginning again forgets what was collected before</source>
        <translation>Sammeln, wo jede Kamera den Ball sieht; neu beginnen vergisst, was vorher gesammelt wurde</translation>
    </message>
    <message>
        <source>■ Stop waving</source>
        <translation>■ Schwenken beenden</translation>
    </message>
    <message>
        <source>● Start waving</source>
        <translation>● Schwenken beginnen</translation>
    </message>
    <message>
        <source>Stop waving</source>
        <translation>Schwenken beenden</translation>
    </message>
    <message>
        <source>Start waving</source>
        <translation>Schwenken beginnen</translation>
    </message>
    <message>
        <source>Nothing collected yet.</source>
        <translation>Noch nichts gesammelt.</translation>
    </message>
    <message>
        <source>%1 collected.</source>
        <translation>%1 gesammelt.</translation>
    </message>
    <message>
        <source>Every camera saw enough: stop, or refine.</source>
        <translation>Jede Kamera hat genug gesehen: beenden oder verfeinern.</translation>
    </message>
    <message>
        <source>Go on: each camera should see the ball 150 times, in half of its image.</source>
        <translation>Weiter: jede Kamera soll den Ball 150-mal sehen, in der Hälfte ihres Bildes.</translation>
    </message>
    <message>
        <source>Image sets left out because they came too fast: %1.</source>
        <translation>Ausgelassene Bildsätze, weil sie zu schnell kamen: %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WindowMenus</name>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Choose this camera</source>
        <translation>Diese Kamera wählen</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Choose this target</source>
        <translation>Dieses Ziel wählen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>&amp;Kalibrierung</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Lauf</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Show this view</source>
        <translation>Diese Ansicht zeigen</translation>
    </message>
    <message>
        <source>Speak this language</source>
        <translation>Diese Sprache sprechen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Wie das System</translation>
    </message>
</context>
</TS>
