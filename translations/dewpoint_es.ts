<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Proyecto nuevo…</translation>
    </message>
    <message>
        <source>Create a project from videos or connected cameras</source>
        <translation>Crear un proyecto con vídeos o cámaras conectadas</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Abrir proyecto…</translation>
    </message>
    <message>
        <source>Open a project file</source>
        <translation>Abrir un archivo de proyecto</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Abrir la demostración</translation>
    </message>
    <message>
        <source>Open the simulated demo scene</source>
        <translation>Abrir la escena de demostración simulada</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save the changes to the project file</source>
        <translation>Guardar los cambios en el archivo del proyecto</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Guardar el proyecto con otro nombre</translation>
    </message>
    <message>
        <source>Close project</source>
        <translation>Cerrar el proyecto</translation>
    </message>
    <message>
        <source>Go back to the start page</source>
        <translation>Volver a la página de inicio</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Quit Dewpoint</source>
        <translation>Salir de Dewpoint</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Edición</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Deshacer el último cambio</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Rehacer el último cambio deshecho</translation>
    </message>
    <message>
        <source>Shortcuts…</source>
        <translation>Atajos…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Reproducir o pausar</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Fotograma siguiente</translation>
    </message>
    <message>
        <source>Track one frame and pause</source>
        <translation>Seguir un fotograma y pausar</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Una iteración</translation>
    </message>
    <message>
        <source>Run one filter iteration on the current frame and pause</source>
        <translation>Ejecutar una iteración del filtro sobre el fotograma actual y pausar</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Start the run again with the same random numbers</source>
        <translation>Empezar de nuevo la ejecución con los mismos números aleatorios</translation>
    </message>
    <message>
        <source>Restart with a new seed</source>
        <translation>Reiniciar con otra semilla</translation>
    </message>
    <message>
        <source>Start the run again with other random numbers</source>
        <translation>Empezar de nuevo la ejecución con otros números aleatorios</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Show mask</source>
        <translation>Mostrar máscara</translation>
    </message>
    <message>
        <source>Show which pixels have the color of a target</source>
        <translation>Mostrar qué píxeles tienen el color de un objetivo</translation>
    </message>
    <message>
        <source>Show the room from above in the bird&apos;s-eye view (XY plane)</source>
        <translation>Mostrar la sala desde arriba en la vista de pájaro (plano XY)</translation>
    </message>
    <message>
        <source>Show the room from the front in the bird&apos;s-eye view (XZ plane)</source>
        <translation>Mostrar la sala desde el frente en la vista de pájaro (plano XZ)</translation>
    </message>
    <message>
        <source>Search actions…</source>
        <translation>Buscar acciones…</translation>
    </message>
    <message>
        <source>Find any action by its name</source>
        <translation>Encontrar cualquier acción por su nombre</translation>
    </message>
    <message>
        <source>Restore the default arrangement of the views</source>
        <translation>Restaurar la disposición predeterminada de las vistas</translation>
    </message>
    <message>
        <source>Use the system&apos;s light or dark colors</source>
        <translation>Usar los colores claros u oscuros del sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Light colors</source>
        <translation>Colores claros</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Dark colors</source>
        <translation>Colores oscuros</translation>
    </message>
    <message>
        <source>Remove the target</source>
        <translation>Quitar el objetivo</translation>
    </message>
    <message>
        <source>Remove the selected target from the project</source>
        <translation>Quitar del proyecto el objetivo seleccionado</translation>
    </message>
    <message>
        <source>Learn the color</source>
        <translation>Aprender el color</translation>
    </message>
    <message>
        <source>Click the target in a camera image to learn its color</source>
        <translation>Hacer clic en el objetivo en una imagen para aprender su color</translation>
    </message>
    <message>
        <source>Add a target</source>
        <translation>Añadir un objetivo</translation>
    </message>
    <message>
        <source>Track one more object: click it in a camera image</source>
        <translation>Seguir un objeto más: haga clic en él en una imagen</translation>
    </message>
    <message>
        <source>Export trajectory…</source>
        <translation>Exportar la trayectoria…</translation>
    </message>
    <message>
        <source>Export the trajectory so far for use in another program</source>
        <translation>Exportar la trayectoria obtenida hasta ahora para otro programa</translation>
    </message>
    <message>
        <source>Save a picture of a view…</source>
        <translation>Guardar una imagen de una vista…</translation>
    </message>
    <message>
        <source>Save a camera image, the bird&apos;s-eye view or a plot as PNG</source>
        <translation>Guardar una imagen de cámara, la vista de pájaro o una gráfica como PNG</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Fotograma anterior</translation>
    </message>
    <message>
        <source>Step back one frame and show its tracking result</source>
        <translation>Mostrar el fotograma anterior tal como se siguió</translation>
    </message>
    <message>
        <source>Go to latest frame</source>
        <translation>Ir al último fotograma</translation>
    </message>
    <message>
        <source>Stop looking back and show the latest tracked frame</source>
        <translation>Dejar de mirar atrás y mostrar el último fotograma seguido</translation>
    </message>
    <message>
        <source>Track again from here</source>
        <translation>Seguir de nuevo desde aquí</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>Añadir marca</translation>
    </message>
    <message>
        <source>Add a named marker at the frame shown</source>
        <translation>Añadir una marca con nombre en el fotograma mostrado</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>Quitar marca</translation>
    </message>
    <message>
        <source>Remove the marker at the frame shown</source>
        <translation>Quitar la marca del fotograma mostrado</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>Marca anterior</translation>
    </message>
    <message>
        <source>Go to the previous marker</source>
        <translation>Ir a la marca anterior</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>Marca siguiente</translation>
    </message>
    <message>
        <source>Go to the next marker</source>
        <translation>Ir a la marca siguiente</translation>
    </message>
    <message>
        <source>Zoom to the selected time span</source>
        <translation>Ampliar el tramo de tiempo seleccionado</translation>
    </message>
    <message>
        <source>Show likelihood map</source>
        <translation>Mostrar mapa de verosimilitud</translation>
    </message>
    <message>
        <source>Show best particle</source>
        <translation>Mostrar la mejor partícula</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Plot spread</source>
        <translation>Mostrar dispersión</translation>
    </message>
    <message>
        <source>Standard deviation of the particles along x, y and z</source>
        <translation>Desviación típica de las partículas en x, y y z</translation>
    </message>
    <message>
        <source>Plot effective sample size</source>
        <translation>Mostrar tamaño efectivo de la muestra</translation>
    </message>
    <message>
        <source>Effective sample size, and number of particles</source>
        <translation>Tamaño efectivo de la muestra y número de partículas</translation>
    </message>
    <message>
        <source>Plot likelihood</source>
        <translation>Mostrar verosimilitud</translation>
    </message>
    <message>
        <source>How well the estimate fits each camera&apos;s image</source>
        <translation>Cuánto encaja la estimación con la imagen de cada cámara</translation>
    </message>
    <message>
        <source>Plot existence</source>
        <translation>Mostrar existencia</translation>
    </message>
    <message>
        <source>Existence probability: from all cameras together, and from each camera alone</source>
        <translation>Probabilidad de existencia: según todas las cámaras juntas y según cada una</translation>
    </message>
    <message>
        <source>Plot error</source>
        <translation>Mostrar error</translation>
    </message>
    <message>
        <source>Distance between estimate and ground truth, if the truth is known</source>
        <translation>Distancia entre la estimación y la posición verdadera, si esta se conoce</translation>
    </message>
    <message>
        <source>Plot time per step</source>
        <translation>Mostrar tiempo por paso</translation>
    </message>
    <message>
        <source>Plot over time</source>
        <translation>Representar en el tiempo</translation>
    </message>
    <message>
        <source>Plot against time in seconds instead of filter iterations</source>
        <translation>Representar según el tiempo en segundos en lugar de las iteraciones del filtro</translation>
    </message>
    <message>
        <source>Show whole run</source>
        <translation>Mostrar toda la ejecución</translation>
    </message>
    <message>
        <source>Show the whole run in the plots again (or double-click)</source>
        <translation>Mostrar de nuevo toda la ejecución en los gráficos (o doble clic)</translation>
    </message>
    <message>
        <source>Copy plots as CSV</source>
        <translation>Copiar gráficos como CSV</translation>
    </message>
    <message>
        <source>Copy the numbers of all plots shown, as a table</source>
        <translation>Copiar los números de los gráficos mostrados como tabla</translation>
    </message>
    <message>
        <source>Save plots as picture…</source>
        <translation>Guardar gráficos como imagen…</translation>
    </message>
    <message>
        <source>Copy trajectory as CSV</source>
        <translation>Copiar trayectoria como CSV</translation>
    </message>
    <message>
        <source>Copy the selected rows of the trajectory, or all rows if none is selected</source>
        <translation>Copiar las filas elegidas de la trayectoria, o todas si no hay ninguna elegida</translation>
    </message>
    <message>
        <source>Calibrate by hand…</source>
        <translation>Calibrar a mano…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Importar calibración…</translation>
    </message>
    <message>
        <source>Export calibration…</source>
        <translation>Exportar calibración…</translation>
    </message>
    <message>
        <source>Refine the calibration by waving a ball, or a wand with two balls</source>
        <translation>Refinar la calibración agitando una pelota, o una varita con dos pelotas</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Calibrate with a board…</source>
        <translation>Calibrar con un tablero…</translation>
    </message>
    <message>
        <source>Find the intrinsics and positions of the cameras with a printed board</source>
        <translation>Hallar los parámetros intrínsecos y las posiciones de las cámaras con un tablero impreso</translation>
    </message>
    <message>
        <source>Print a calibration board…</source>
        <translation>Imprimir un tablero de calibración…</translation>
    </message>
    <message>
        <source>Save the calibration board as a PDF at its true size</source>
        <translation>Guardar el tablero de calibración como PDF a tamaño real</translation>
    </message>
    <message>
        <source>Plan the rig…</source>
        <translation>Planificar el montaje…</translation>
    </message>
    <message>
        <source>See how accurately the cameras will measure, and where another camera would help</source>
        <translation>Ver con qué precisión medirán las cámaras y dónde ayudaría otra cámara</translation>
    </message>
    <message>
        <source>Show error map</source>
        <translation>Mostrar mapa de errores</translation>
    </message>
    <message>
        <source>Add planned camera</source>
        <translation>Añadir cámara planeada</translation>
    </message>
    <message>
        <source>Add a planned camera; you can then drag it in the bird&apos;s-eye view to try out where to place it</source>
        <translation>Añadir una cámara planeada; después puede arrastrarla en la vista de pájaro para probar dónde colocarla</translation>
    </message>
    <message>
        <source>Recompute the pose of the camera that was moved during the run; all other cameras stay unchanged</source>
        <translation>Recalcular la pose de la cámara que se movió durante la ejecución; las demás cámaras no cambian</translation>
    </message>
    <message>
        <source>Find best camera position</source>
        <translation>Buscar mejor posición de cámara</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the position where another camera would help most</source>
        <translation>Buscar en paredes y techo la posición donde más ayudaría otra cámara</translation>
    </message>
    <message>
        <source>Experiments…</source>
        <translation>Experimentos…</translation>
    </message>
    <message>
        <source>Set box</source>
        <translation>Fijar recuadro</translation>
    </message>
    <message>
        <source>Export 3D shapes of people…</source>
        <translation>Exportar formas 3D de las personas…</translation>
    </message>
    <message>
        <source>Save tables of each person&apos;s position, volume, hull and density on the floor</source>
        <translation>Guardar tablas con la posición, el volumen, la envolvente y la densidad en el suelo de cada persona</translation>
    </message>
    <message>
        <source>Add person…</source>
        <translation>Añadir persona…</translation>
    </message>
    <message>
        <source>Click the person in a camera image, or the floor in the bird&apos;s-eye view</source>
        <translation>Haga clic en la persona en una imagen de cámara, o en el suelo en la vista de pájaro</translation>
    </message>
    <message>
        <source>Remove person</source>
        <translation>Quitar persona</translation>
    </message>
    <message>
        <source>Remove the person selected in the table</source>
        <translation>Quitar a la persona elegida en la tabla</translation>
    </message>
    <message>
        <source>Show 3D shapes of people</source>
        <translation>Mostrar formas 3D de las personas</translation>
    </message>
    <message>
        <source>Filter threads…</source>
        <translation>Hilos del filtro…</translation>
    </message>
    <message>
        <source>Choose how many processor threads compute the filter</source>
        <translation>Elegir cuántos hilos del procesador calculan el filtro</translation>
    </message>
    <message>
        <source>Correct position</source>
        <translation>Corregir posición</translation>
    </message>
    <message>
        <source>Drag a target in the camera images to its true position in this frame; tracking continues from there</source>
        <translation>Arrastrar un objetivo en las imágenes de cámara a su posición real en este fotograma; el seguimiento continúa desde ahí</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Quitar corrección</translation>
    </message>
    <message>
        <source>Remove the correction of the selected target in this frame, or of all targets if none is selected</source>
        <translation>Quitar la corrección del objetivo elegido en este fotograma, o de todos si no hay ninguno elegido</translation>
    </message>
    <message>
        <source>Show the volume of interest</source>
        <translation>Mostrar el volumen de interés</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>Seguir de nuevo</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Más lento</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Más rápido</translation>
    </message>
    <message>
        <source>Normal speed</source>
        <translation>Velocidad normal</translation>
    </message>
    <message>
        <source>Play the recording as fast as it was filmed</source>
        <translation>Reproducir la grabación a la velocidad a la que se filmó</translation>
    </message>
    <message>
        <source>Play slowly until converged</source>
        <translation>Reproducir despacio hasta converger</translation>
    </message>
    <message>
        <source>Show magnifier</source>
        <translation>Mostrar lupa</translation>
    </message>
    <message>
        <source>Show lines of sight</source>
        <translation>Mostrar líneas de visión</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Acercar</translation>
    </message>
    <message>
        <source>Zoom in on the camera image under the pointer, or on the image of the selected camera (or use the mouse wheel)</source>
        <translation>Acercar la imagen de cámara bajo el puntero, o la de la cámara elegida (también con la rueda)</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Alejar</translation>
    </message>
    <message>
        <source>Zoom out of the camera image under the pointer, or of the image of the selected camera</source>
        <translation>Alejar la imagen de cámara bajo el puntero, o la de la cámara elegida</translation>
    </message>
    <message>
        <source>Fit image</source>
        <translation>Ajustar imagen</translation>
    </message>
    <message>
        <source>Show the whole camera image (or double-click)</source>
        <translation>Mostrar toda la imagen de cámara (o doble clic)</translation>
    </message>
    <message>
        <source>Top view</source>
        <translation>Vista desde arriba</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>Vista desde el frente</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vista 3D</translation>
    </message>
    <message>
        <source>Fit everything in view</source>
        <translation>Ajustar todo a la vista</translation>
    </message>
    <message>
        <source>Show the whole room in the bird&apos;s-eye view (or double-click)</source>
        <translation>Mostrar toda la sala en la vista de pájaro (o doble clic)</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Restablecer la disposición</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Pantalla completa</translation>
    </message>
    <message>
        <source>Switch between full screen and a normal window</source>
        <translation>Alternar entre pantalla completa y ventana normal</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Según el sistema</translation>
    </message>
    <message>
        <source>Plot position</source>
        <translation>Mostrar posición</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Open the manual at the page about the active view</source>
        <translation>Abrir el manual en la página sobre la vista activa</translation>
    </message>
    <message>
        <source>Quick start</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>What you see in the window, and how to begin in five steps</source>
        <translation>Qué se ve en la ventana y cómo empezar en cinco pasos</translation>
    </message>
    <message>
        <source>Legend of the overlays</source>
        <translation>Leyenda de los signos</translation>
    </message>
    <message>
        <source>What crosses, ellipses and dots in the images mean</source>
        <translation>Qué significan las cruces, elipses y puntos en las imágenes</translation>
    </message>
    <message>
        <source>About the methods</source>
        <translation>Acerca de los métodos</translation>
    </message>
    <message>
        <source>Open the reference of the tracking methods</source>
        <translation>Abrir la referencia de los métodos de seguimiento</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Informar de un problema…</translation>
    </message>
    <message>
        <source>Collect the information that a bug report needs, ready to copy</source>
        <translation>Reunir la información que necesita un informe de error, lista para copiar</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Acerca de Dewpoint</translation>
    </message>
    <message>
        <source>Version, license, and how to cite Dewpoint</source>
        <translation>Versión, licencia y cómo citar Dewpoint</translation>
    </message>
    <message>
        <source>Show images in the bird&apos;s-eye view</source>
        <translation>Mostrar las imágenes en la vista de pájaro</translation>
    </message>
    <message>
        <source>Show each camera&apos;s image inside its viewing pyramid in the bird&apos;s-eye view</source>
        <translation>Mostrar en la vista de pájaro la imagen de cada cámara en su pirámide de visión</translation>
    </message>
    <message>
        <source>Set floor and origin…</source>
        <translation>Definir suelo y origen…</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Calibrar…</translation>
    </message>
    <message>
        <source>See what is known about the cameras, and calibrate them step by step in the way that you choose</source>
        <translation>Ver lo que se sabe de las cámaras y calibrarlas paso a paso de la forma que elija</translation>
    </message>
    <message>
        <source>Play the first iterations of a run one by one, until every target is being tracked (five seconds at most)</source>
        <translation>Reproducir una a una las primeras iteraciones de una ejecución, hasta que todos los objetivos estén seguidos (cinco segundos como máximo)</translation>
    </message>
    <message>
        <source>See and change all keyboard shortcuts</source>
        <translation>Ver y cambiar todos los atajos de teclado</translation>
    </message>
    <message>
        <source>Adjust the calibration of the cameras until a grid drawn over their images matches the real scene</source>
        <translation>Ajustar la calibración de las cámaras hasta que una cuadrícula dibujada sobre sus imágenes coincida con la escena real</translation>
    </message>
    <message>
        <source>Set the floor, the origin, the axes and the scale of the room with points that you mark in the images</source>
        <translation>Definir el suelo, el origen, los ejes y la escala de la sala con puntos que marca en las imágenes</translation>
    </message>
    <message>
        <source>Load the calibration of the cameras from a file that another program wrote</source>
        <translation>Cargar la calibración de las cámaras de un archivo escrito por otro programa</translation>
    </message>
    <message>
        <source>Save the calibration of the cameras for another program</source>
        <translation>Guardar la calibración de las cámaras para otro programa</translation>
    </message>
    <message>
        <source>In the bird&apos;s-eye view, show the position error to expect for a target at each point</source>
        <translation>Mostrar en la vista de pájaro el error de posición que cabe esperar para un objetivo en cada punto</translation>
    </message>
    <message>
        <source>Track again from the frame shown, with the current method, parameters and colors. To stop, press Pause</source>
        <translation>Seguir de nuevo desde el fotograma mostrado, con el método, los parámetros y los colores actuales. Para detenerlo, pulse Pausa</translation>
    </message>
    <message>
        <source>Track again every frame that was last tracked with earlier settings</source>
        <translation>Seguir de nuevo todos los fotogramas que se siguieron por última vez con ajustes anteriores</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to 1/30 of the normal speed</source>
        <translation>Reproducir la grabación más despacio, hasta 1/30 de la velocidad normal</translation>
    </message>
    <message>
        <source>Play the recording faster, up to eight times the normal speed</source>
        <translation>Reproducir la grabación más rápido, hasta ocho veces la velocidad normal</translation>
    </message>
    <message>
        <source>Fill the timeline with the selected span of the recording</source>
        <translation>Llenar la línea de tiempo con el tramo seleccionado de la grabación</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Record the live cameras into a folder that opens as a project, or stop recording</source>
        <translation>Grabar las cámaras en directo en una carpeta que se abre como proyecto, o detener la grabación</translation>
    </message>
    <message>
        <source>Send results</source>
        <translation>Enviar resultados</translation>
    </message>
    <message>
        <source>Start or stop sending positions to other programs during the run. Until you start sending, nothing is sent</source>
        <translation>Empezar o dejar de enviar posiciones a otros programas durante la ejecución. Mientras no inicie el envío, no se envía nada</translation>
    </message>
    <message>
        <source>Outputs…</source>
        <translation>Salidas…</translation>
    </message>
    <message>
        <source>Choose where results are sent: TCP, WebSocket, OSC, TUIO, CSV</source>
        <translation>Elegir adónde se envían los resultados: TCP, WebSocket, OSC, TUIO, CSV</translation>
    </message>
    <message>
        <source>Reproduce figures from the papers that describe the methods, and write a report</source>
        <translation>Reproducir figuras de los artículos que describen los métodos y escribir un informe</translation>
    </message>
    <message>
        <source>Show how likely each position around the target is. Circles mark positions at which the method suspects the target</source>
        <translation>Mostrar la verosimilitud de cada posición alrededor del objetivo. Los círculos marcan posiciones en las que el método supone que puede estar el objetivo</translation>
    </message>
    <message>
        <source>In all views, draw a triangle at the particle of each target that has the highest weight</source>
        <translation>Dibujar en todas las vistas un triángulo en la partícula de mayor peso de cada objetivo</translation>
    </message>
    <message>
        <source>When a target&apos;s particles are too close together to tell apart, show them enlarged</source>
        <translation>Cuando las partículas de un objetivo están demasiado juntas para distinguirlas, mostrarlas ampliadas</translation>
    </message>
    <message>
        <source>In the bird&apos;s-eye view, draw a line from each camera to the target. The line is dashed if the camera cannot see the target</source>
        <translation>Dibujar en la vista de pájaro una línea de cada cámara al objetivo. La línea es discontinua si la cámara no ve el objetivo</translation>
    </message>
    <message>
        <source>Draw the volume of interest in the images and in the bird&apos;s-eye view: targets are searched for only inside this box</source>
        <translation>Dibujar el volumen de interés en las imágenes y en la vista de pájaro: los objetivos se buscan solo dentro de esta caja</translation>
    </message>
    <message>
        <source>Show the hull that encloses 95 % of each person&apos;s volume, and lines on the floor around the areas that contain 25, 50, 75 and 95 % of each person</source>
        <translation>Mostrar la envolvente que encierra el 95 % del volumen de cada persona y las líneas en el suelo alrededor de las áreas que contienen el 25, 50, 75 y 95 % de cada persona</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view in perspective; drag to rotate it</source>
        <translation>Vista de pájaro en perspectiva; arrastre para girarla</translation>
    </message>
    <message>
        <source>Position along x, y and z, with a band of plus and minus two standard deviations, and the true position if it is known</source>
        <translation>Posición en x, y y z, con una banda de más y menos dos desviaciones típicas, y la posición verdadera si se conoce</translation>
    </message>
    <message>
        <source>Time that one filter iteration takes for one target, in microseconds</source>
        <translation>Tiempo que tarda una iteración del filtro con un objetivo, en microsegundos</translation>
    </message>
    <message>
        <source>Save a picture of the plots as they look now, as SVG or PNG</source>
        <translation>Guardar una imagen de los gráficos tal como se ven ahora, en SVG o PNG</translation>
    </message>
    <message>
        <source>Check project…</source>
        <translation>Comprobar el proyecto…</translation>
    </message>
    <message>
        <source>Check the recordings, times, calibration, colors and method of the project for problems</source>
        <translation>Buscar problemas en las grabaciones, los tiempos, la calibración, los colores y el método del proyecto</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>Cámaras…</translation>
    </message>
    <message>
        <source>Add, remove, replace and adjust the cameras of the project</source>
        <translation>Añadir, quitar, sustituir y ajustar las cámaras del proyecto</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>Fijar colores</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of all connected cameras, and keep the current values</source>
        <translation>Desactivar la exposición, la ganancia y el balance de blancos automáticos de todas las cámaras conectadas y conservar los valores actuales</translation>
    </message>
    <message>
        <source>Export video…</source>
        <translation>Exportar vídeo…</translation>
    </message>
    <message>
        <source>Save the camera views and the bird&apos;s-eye view as a video</source>
        <translation>Guardar las vistas de las cámaras y la vista de pájaro como vídeo</translation>
    </message>
    <message>
        <source>Set take number and notes…</source>
        <translation>Número y notas de la toma…</translation>
    </message>
    <message>
        <source>Set the number and notes of the next take, or the notes of the current take</source>
        <translation>Fijar el número y las notas de la próxima toma, o las notas de la actual</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Read the messages of this window again, with their times, and copy them</source>
        <translation>Volver a leer los mensajes de esta ventana, con sus horas, y copiarlos</translation>
    </message>
    <message>
        <source>Go to frame…</source>
        <translation>Ir al fotograma…</translation>
    </message>
    <message>
        <source>Enter a frame number, or a time such as 2.5 s, and go there</source>
        <translation>Introducir un número de fotograma, o un tiempo como 2,5 s, e ir allí</translation>
    </message>
    <message>
        <source>Previous trouble</source>
        <translation>Problema anterior</translation>
    </message>
    <message>
        <source>Go back to the frame where tracking of the selected target was lost or became uncertain, or where a camera had a problem. If no target is selected, all targets count</source>
        <translation>Volver al fotograma en el que se perdió el seguimiento del objetivo seleccionado o se volvió incierto, o en el que una cámara tuvo un problema. Si no hay ningún objetivo seleccionado, cuentan todos</translation>
    </message>
    <message>
        <source>Next trouble</source>
        <translation>Problema siguiente</translation>
    </message>
    <message>
        <source>Go to the next frame where tracking of the selected target is lost or becomes uncertain, or where a camera has a problem. If no target is selected, all targets count</source>
        <translation>Ir al siguiente fotograma en el que se pierde el seguimiento del objetivo seleccionado o se vuelve incierto, o en el que una cámara tiene un problema. Si no hay ningún objetivo seleccionado, cuentan todos</translation>
    </message>
    <message>
        <source>Side view</source>
        <translation>Vista lateral</translation>
    </message>
    <message>
        <source>Show the room from the side in the bird&apos;s-eye view (YZ plane)</source>
        <translation>Mostrar la sala desde un lado en la vista de pájaro (plano YZ)</translation>
    </message>
    <message>
        <source>Hide or show the target</source>
        <translation>Ocultar o mostrar el objetivo</translation>
    </message>
    <message>
        <source>Hide the selected target in the images and in the bird&apos;s-eye view, or show it again. A hidden target is still tracked</source>
        <translation>Ocultar el objetivo seleccionado en las imágenes y en la vista de pájaro, o volver a mostrarlo. Un objetivo oculto se sigue igualmente</translation>
    </message>
    <message>
        <source>Calibrate with a wand…</source>
        <translation>Calibrar con una varita…</translation>
    </message>
    <message>
        <source>Recompute pose of moved camera</source>
        <translation>Recalcular pose de la cámara movida</translation>
    </message>
</context>
<context>
    <name>AssessedRegions</name>
    <message>
        <source>also has the target&apos;s color</source>
        <translation>también tiene el color del objetivo</translation>
    </message>
    <message>
        <source>recognized as the target (if this is wrong, Ctrl+Shift-click here)</source>
        <translation>reconocido como objetivo (si es un error, Ctrl+Mayús+clic aquí)</translation>
    </message>
    <message>
        <source>some pixels also have the target&apos;s color</source>
        <translation>algunos píxeles también tienen el color del objetivo</translation>
    </message>
</context>
<context>
    <name>BoardText</name>
    <message>
        <source>The board&apos;s corners cover only %1 % of the image: show the board in every part of the image, and tilt it too.</source>
        <translation>Las esquinas del tablero cubren solo el %1 % de la imagen: muestre el tablero en todas las partes de la imagen e inclínelo también.</translation>
    </message>
    <message>
        <source>%1 keeps its position because it never saw the board.</source>
        <translation>%1 conserva su posición porque nunca vio el tablero.</translation>
    </message>
    <message>
        <source>Intrinsics</source>
        <translation>Parámetros intrínsecos</translation>
    </message>
    <message>
        <source>The intrinsics of %1 are unchanged: %2</source>
        <translation>Los parámetros intrínsecos de %1 no cambian: %2</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>arriba a la izquierda</translation>
    </message>
    <message>
        <source>top</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>arriba a la derecha</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>center</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>abajo a la izquierda</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>abajo</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>abajo a la derecha</translation>
    </message>
    <message>
        <source>left side closer to the camera</source>
        <translation>con el lado izquierdo más cerca de la cámara</translation>
    </message>
    <message>
        <source>right side closer to the camera</source>
        <translation>con el lado derecho más cerca de la cámara</translation>
    </message>
    <message>
        <source>upper side closer to the camera</source>
        <translation>con el lado superior más cerca de la cámara</translation>
    </message>
    <message>
        <source>lower side closer to the camera</source>
        <translation>con el lado inferior más cerca de la cámara</translation>
    </message>
    <message>
        <source>facing the camera</source>
        <translation>de frente a la cámara</translation>
    </message>
    <message>
        <source>No image yet</source>
        <translation>Aún sin imagen</translation>
    </message>
    <message>
        <source>Show the whole board</source>
        <translation>Muestre el tablero entero</translation>
    </message>
    <message>
        <source>Move the board to: %1</source>
        <translation>Mueva el tablero a: %1</translation>
    </message>
    <message>
        <source>Turn the board: %1</source>
        <translation>Oriente el tablero: %1</translation>
    </message>
    <message>
        <source>Move the board closer</source>
        <translation>Acerque el tablero</translation>
    </message>
    <message>
        <source>Hold the board still</source>
        <translation>Mantenga quieto el tablero</translation>
    </message>
    <message>
        <source>The image is blurred: focus the lens or add light</source>
        <translation>La imagen está borrosa: enfoque o añada luz</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ Listo</translation>
    </message>
    <message>
        <source>✓ The cameras share enough views of the board</source>
        <translation>✓ Las cámaras comparten suficientes vistas del tablero</translation>
    </message>
    <message>
        <source>Show the board to %1 and %2 at the same time, hold it still, then repeat elsewhere</source>
        <translation>Muestre el tablero a %1 y %2 a la vez, manténgalo quieto y repita en otro lugar</translation>
    </message>
    <message>
        <source>board not visible</source>
        <translation>tablero no visible</translation>
    </message>
    <message>
        <source>⚠ blurred: edges are %1 wide</source>
        <translation>⚠ borroso: los bordes miden %1 de ancho</translation>
    </message>
    <message>
        <source>sharp: edges are %1 wide</source>
        <translation>nítido: los bordes miden %1 de ancho</translation>
    </message>
    <message>
        <source>%1 views, accuracy %2 (goal: %3)</source>
        <translation>%1 vistas, precisión %2 (meta: %3)</translation>
    </message>
    <message>
        <source>● board visible</source>
        <translation>● tablero visible</translation>
    </message>
    <message>
        <source>○ board not visible</source>
        <translation>○ tablero no visible</translation>
    </message>
    <message>
        <source>%1 views, position accuracy %2</source>
        <translation>%1 vistas, precisión de posición %2</translation>
    </message>
    <message>
        <source>%1 views shared with other cameras</source>
        <translation>%1 vistas comunes con otras cámaras</translation>
    </message>
    <message>
        <source>The camera positions could not be computed: %1</source>
        <translation>No se pudieron calcular las posiciones de las cámaras: %1</translation>
    </message>
    <message>
        <source>The accuracy cannot be estimated, because two cameras rarely saw the board at the same time.</source>
        <translation>No se puede estimar la precisión, porque muy pocas veces vieron dos cámaras el tablero a la vez.</translation>
    </message>
    <message>
        <source>a chessboard with %1 × %2 inner corners</source>
        <translation>un tablero de ajedrez con %1 × %2 esquinas interiores</translation>
    </message>
    <message>
        <source>a ChArUco board with %1 × %2 squares, %3</source>
        <translation>un tablero ChArUco con %1 × %2 casillas, %3</translation>
    </message>
    <message>
        <source>legacy layout</source>
        <translation>disposición antigua</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2, focal length %3, accuracy of the intrinsics %5, from %4 images</source>
        <translation>%1: error de reproyección RMS %2, distancia focal %3, precisión de los parámetros intrínsecos %5, con %4 imágenes</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2, position ±%3, direction ±%4</source>
        <translation>%1: error de reproyección RMS %2, posición ±%3, dirección ±%4</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2</source>
        <translation>%1: error de reproyección RMS %2</translation>
    </message>
    <message>
        <source>Camera positions: RMS reprojection error %1, from %2 board poses</source>
        <translation>Posiciones de las cámaras: error de reproyección RMS %1, con %2 poses del tablero</translation>
    </message>
    <message>
        <source>%1 views; at least %2 are needed</source>
        <translation>%1 vistas; se necesitan al menos %2</translation>
    </message>
    <message>
        <source>inverted colors</source>
        <translation>colores invertidos</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show %3, but mirrored. To correct this, change “Mirrored” in the panel Cameras for the cameras that took these images. Use this board?</source>
        <translation>%1 de las %2 imágenes examinadas muestran %3, pero reflejado. Para corregirlo, cambie «Reflejada» en el panel Cámaras para las cámaras que tomaron estas imágenes. ¿Usar este tablero?</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show %3. Use this board?</source>
        <translation>%1 de las %2 imágenes examinadas muestran %3. ¿Usar este tablero?</translation>
    </message>
    <message>
        <source>%1 (too few corners: %2)</source>
        <translation>%1 (muy pocas esquinas: %2)</translation>
    </message>
    <message>
        <source>%1 (blurred: edges are %2 wide)</source>
        <translation>%1 (borroso: los bordes miden %2 de ancho)</translation>
    </message>
    <message>
        <source>%1 (too small: squares are only %2 wide)</source>
        <translation>%1 (demasiado pequeño: las casillas miden solo %2)</translation>
    </message>
    <message>
        <source>%1: no board was found in frames %2.</source>
        <translation>%1: no se encontró ningún tablero en los fotogramas %2.</translation>
    </message>
    <message>
        <source>%1: no board was found in frames %2 and in %3 others.</source>
        <translation>%1: no se encontró ningún tablero en los fotogramas %2 ni en otros %3.</translation>
    </message>
    <message>
        <source>The video of %1 is mirrored: it shows the board mirrored, but another camera shows the board the right way round.</source>
        <translation>El vídeo de %1 está reflejado: muestra el tablero reflejado, pero otra cámara lo muestra sin reflejar.</translation>
    </message>
    <message>
        <source>The board or the video of %1 is mirrored: no camera shows the board the right way round. Check whether writing in the images is readable.</source>
        <translation>El tablero o el vídeo de %1 está reflejado: ninguna cámara muestra el tablero sin reflejar. Compruebe si los textos en las imágenes son legibles.</translation>
    </message>
</context>
<context>
    <name>CalibrationFiles</name>
    <message>
        <source>Calibrations (%1)</source>
        <translation>Calibraciones (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>CalibrationText</name>
    <message>
        <source>The images of %1 are %2 times as large as those for which it was calibrated: its intrinsics are for another resolution. Convert the intrinsics, or record at the calibrated size.</source>
        <translation>Las imágenes de %1 son %2 veces mayores que aquellas para las que se calibró: sus parámetros intrínsecos son de otra resolución. Convierta los parámetros o grabe con el tamaño calibrado.</translation>
    </message>
    <message>
        <source>all cameras</source>
        <translation>todas las cámaras</translation>
    </message>
    <message>
        <source>All cameras seem to see the board from behind, or the floor from below: the measured points are probably mirrored. Check the direction of the axes, and make sure that the printed board is not mirrored.</source>
        <translation>Todas las cámaras parecen ver el tablero por detrás o el suelo por debajo: probablemente los puntos medidos están reflejados. Compruebe la dirección de los ejes y que el tablero no se haya impreso invertido.</translation>
    </message>
    <message>
        <source>Everything fits when %1 and %2 are exchanged: their videos are probably swapped. Exchange the two files.</source>
        <translation>Todo encaja al intercambiar %1 y %2: probablemente sus vídeos están cambiados. Intercambie los dos archivos.</translation>
    </message>
    <message>
        <source>%1 agrees with the other cameras only if its video is shifted in time: the video is probably %2 frames late. Synchronize the videos, or calibrate with a wand and turn on “Find delays”.</source>
        <translation>%1 solo concuerda con las demás cámaras si su vídeo se desplaza en el tiempo: probablemente va %2 fotogramas retrasado. Sincronice los vídeos, o calibre con la varita y active «Buscar retrasos».</translation>
    </message>
    <message>
        <source>%1 agrees with the other cameras only if its video is shifted in time: the video is probably %2 frames early. Synchronize the videos, or calibrate with a wand and turn on “Find delays”.</source>
        <translation>%1 solo concuerda con las demás cámaras si su vídeo se desplaza en el tiempo: probablemente va %2 fotogramas adelantado. Sincronice los vídeos, o calibre con la varita y active «Buscar retrasos».</translation>
    </message>
    <message>
        <source>The images of %1 fit one pose before %2 and another pose after that time: the camera was probably moved. Calibrate with the later part of the recording only.</source>
        <translation>Las imágenes de %1 encajan con una pose antes de %2 y con otra después: probablemente la cámara se movió. Calibre solo con la parte posterior de la grabación.</translation>
    </message>
    <message>
        <source>The images of %1 fit only if they are flipped: the video is probably mirrored or upside down. Set the rotation and mirroring of these images.</source>
        <translation>Las imágenes de %1 solo encajan si se voltean: el vídeo probablemente está reflejado o boca abajo. Ajuste el giro y el reflejo de estas imágenes.</translation>
    </message>
    <message>
        <source>The images of %1 fit a focal length that is %2 times the one in its calibration: the zoom or crop of the camera was probably changed. Calibrate its intrinsics again.</source>
        <translation>Las imágenes de %1 encajan con una distancia focal %2 veces la de su calibración: probablemente cambió el zoom o el recorte de la cámara. Calibre de nuevo sus parámetros intrínsecos.</translation>
    </message>
    <message>
        <source>The length that you entered is %1 times the length that the cameras see: millimeters and meters are probably mixed up.</source>
        <translation>La longitud que introdujo es %1 veces la que ven las cámaras: probablemente se confundieron milímetros y metros.</translation>
    </message>
    <message>
        <source>The length that you entered is %1 times the length that the cameras see: you probably entered it in inches (1 inch = 2.54 cm).</source>
        <translation>La longitud que introdujo es %1 veces la que ven las cámaras: probablemente la introdujo en pulgadas (1 pulgada = 2,54 cm).</translation>
    </message>
    <message>
        <source>The corners form a board with %1 squares in a row, so the number of squares that you entered is probably wrong. Count the squares and correct the number.</source>
        <translation>Las esquinas forman un tablero con %1 casillas por fila, así que el número de casillas que introdujo probablemente es erróneo. Cuente las casillas y corrija el número.</translation>
    </message>
    <message>
        <source>The size of the squares that you entered is %1 times the size that the cameras see. Measure a row with a ruler: prints are often rescaled.</source>
        <translation>El tamaño de las casillas que introdujo es %1 veces el que ven las cámaras. Mida una fila con una regla: las impresiones suelen cambiar de escala.</translation>
    </message>
    <message>
        <source>The images fit only if they are shifted by %1 along both axes: the calibration probably counts pixel coordinates from the corner of the first pixel, not from its center. Convert the principal points.</source>
        <translation>Las imágenes solo encajan desplazadas %1 en ambos ejes: probablemente la calibración cuenta las coordenadas de los píxeles desde la esquina del primer píxel y no desde su centro. Convierta los puntos principales.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocida</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source>±%1 %</source>
        <translation>±%1 %</translation>
    </message>
    <message>
        <source>not measured yet (use the page Floor)</source>
        <translation>aún sin medir (use la página Suelo)</translation>
    </message>
    <message>
        <source>In the calibrated volume: position %1, scale %2, upward direction %3 (95 % of the errors are smaller).</source>
        <translation>En el volumen calibrado: posición %1, escala %2, dirección hacia arriba %3 (el 95 % de los errores es menor).</translation>
    </message>
    <message>
        <source>Outside the calibrated volume, up to %1 away: position ±%2 (extrapolated).</source>
        <translation>Fuera del volumen calibrado, hasta a %1 de distancia: posición ±%2 (extrapolado).</translation>
    </message>
</context>
<context>
    <name>CameraAgreement</name>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped, or %3 and %4.</source>
        <translation>%1 y %2 parecen estar intercambiadas, o bien %3 y %4.</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped.</source>
        <translation>%1 y %2 parecen estar intercambiadas.</translation>
    </message>
    <message>
        <source>%1 or %2 points at least %3 away from its calibrated direction.</source>
        <translation>%1 o %2 apunta al menos %3 fuera de su dirección calibrada.</translation>
    </message>
    <message>
        <source>%1 points about %2 away from its calibrated direction.</source>
        <translation>%1 apunta unos %2 fuera de su dirección calibrada.</translation>
    </message>
    <message>
        <source>%1 and %2 disagree about where the target is. Calibrate them again.</source>
        <translation>%1 y %2 no ven el objetivo en la misma posición. Calíbrelas de nuevo.</translation>
    </message>
    <message>
        <source>%1 does not agree with the other cameras. Calibrate it again.</source>
        <translation>%1 no concuerda con las demás cámaras. Calíbrela de nuevo.</translation>
    </message>
    <message>
        <source>The images of %1 are about %2 late.</source>
        <translation>Las imágenes de %1 llevan un retraso de unos %2.</translation>
    </message>
    <message>
        <source>The images of %1 are about %2 early.</source>
        <translation>Las imágenes de %1 llevan un adelanto de unos %2.</translation>
    </message>
    <message>
        <source>The calibration seems to be in %1 instead of meters.</source>
        <translation>La calibración parece estar en %1 en vez de en metros.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 y %2 tienen la misma pose.</translation>
    </message>
    <message>
        <source>Swap %1 and %2</source>
        <translation>Intercambiar %1 y %2</translation>
    </message>
    <message>
        <source>Set the delay of %1</source>
        <translation>Ajustar el retraso de %1</translation>
    </message>
    <message>
        <source>Correct direction of %1</source>
        <translation>Corregir dirección de %1</translation>
    </message>
    <message>
        <source>Convert to meters</source>
        <translation>Convertir a metros</translation>
    </message>
</context>
<context>
    <name>CameraDeviceText</name>
    <message>
        <source>Brightness</source>
        <translation>Brillo</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Contraste</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturación</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Tono</translation>
    </message>
    <message>
        <source>Automatic hue</source>
        <translation>Tono automático</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Ganancia</translation>
    </message>
    <message>
        <source>Automatic gain</source>
        <translation>Ganancia automática</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Nitidez</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>Exposición automática</translation>
    </message>
    <message>
        <source>Exposure time (× 0.1 ms)</source>
        <translation>Tiempo de exposición (× 0,1 ms)</translation>
    </message>
    <message>
        <source>Lower frame rate in low light</source>
        <translation>Menor frecuencia de imagen con poca luz</translation>
    </message>
    <message>
        <source>Automatic white balance</source>
        <translation>Balance de blancos automático</translation>
    </message>
    <message>
        <source>White balance (K)</source>
        <translation>Balance de blancos (K)</translation>
    </message>
    <message>
        <source>Backlight compensation</source>
        <translation>Compensación de contraluz</translation>
    </message>
    <message>
        <source>Power line frequency</source>
        <translation>Frecuencia de la red eléctrica</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Enfoque</translation>
    </message>
    <message>
        <source>Automatic focus</source>
        <translation>Enfoque automático</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Giro horizontal</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinación</translation>
    </message>
    <message>
        <source>connector %1</source>
        <translation>conector %1</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>número de serie %1</translation>
    </message>
    <message>
        <source>%1, %2 images per second</source>
        <translation>%1, %2 imágenes por segundo</translation>
    </message>
    <message>
        <source>%1 %2, %3 images per second</source>
        <translation>%1 %2, %3 imágenes por segundo</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>on, manual exposure time</source>
        <translation>activada, tiempo de exposición manual</translation>
    </message>
    <message>
        <source>on, manual aperture</source>
        <translation>activada, apertura manual</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>exposición</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>ganancia</translation>
    </message>
    <message>
        <source>white balance</source>
        <translation>balance de blancos</translation>
    </message>
    <message>
        <source>hue</source>
        <translation>tono</translation>
    </message>
    <message>
        <source>USB bus %1 cannot carry the images of %2: they need %3 Mbit/s, but the bus has only %4 Mbit/s.</source>
        <translation>El bus USB %1 no puede transmitir las imágenes de %2: necesitan %3 Mbit/s y dispone de %4 Mbit/s.</translation>
    </message>
</context>
<context>
    <name>CameraMotion</name>
    <message>
        <source>rotated by %1</source>
        <translation>girada %1</translation>
    </message>
</context>
<context>
    <name>CameraNames</name>
    <message>
        <source>camera %1</source>
        <translation>cámara %1</translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>This camera delivered no image for this frame.</source>
        <translation>Esta cámara no entregó imagen para este fotograma.</translation>
    </message>
    <message>
        <source>No images yet. Press play (Space), or open a project (Ctrl+O).</source>
        <translation>Aún no hay imágenes. Pulse reproducir (Espacio) o abra un proyecto (Ctrl+O).</translation>
    </message>
</context>
<context>
    <name>ClickRadiusText</name>
    <message>
        <source>The target&apos;s radius seems to be about %1.</source>
        <translation>El radio del objetivo parece ser de unos %1.</translation>
    </message>
    <message>
        <source>The marked spot is part of a larger object of the same color. Only this spot is tracked, as a ball with radius %1.</source>
        <translation>El punto marcado es parte de un objeto mayor del mismo color. Solo se sigue este punto, como una pelota con radio %1.</translation>
    </message>
    <message>
        <source>The target&apos;s radius seems to be about %1, but %2 was entered. Is %2 the diameter?</source>
        <translation>El radio del objetivo parece ser de unos %1, pero se introdujo %2. ¿Es %2 el diámetro?</translation>
    </message>
    <message>
        <source>The target&apos;s radius seems to be about %1, but %2 was entered.</source>
        <translation>El radio del objetivo parece ser de unos %1, pero se introdujo %2.</translation>
    </message>
</context>
<context>
    <name>ColorLearner</name>
    <message>
        <source>target %1</source>
        <translation>objetivo %1</translation>
    </message>
</context>
<context>
    <name>ColorText</name>
    <message>
        <source>at the top left</source>
        <translation>arriba a la izquierda</translation>
    </message>
    <message>
        <source>at the top</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>at the top right</source>
        <translation>arriba a la derecha</translation>
    </message>
    <message>
        <source>at the left</source>
        <translation>a la izquierda</translation>
    </message>
    <message>
        <source>in the center</source>
        <translation>en el centro</translation>
    </message>
    <message>
        <source>at the right</source>
        <translation>a la derecha</translation>
    </message>
    <message>
        <source>at the bottom left</source>
        <translation>abajo a la izquierda</translation>
    </message>
    <message>
        <source>at the bottom</source>
        <translation>abajo</translation>
    </message>
    <message>
        <source>at the bottom right</source>
        <translation>abajo a la derecha</translation>
    </message>
    <message>
        <source>black</source>
        <translation>negro</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>gris</translation>
    </message>
    <message>
        <source>white</source>
        <translation>blanco</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>marrón</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rojo</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>naranja</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>amarillo</translation>
    </message>
    <message>
        <source>green</source>
        <translation>verde</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>turquesa</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>azul</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>morado</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>rosa</translation>
    </message>
    <message>
        <source>Much of the target does not have the learned color: Shift-click its light and its dark side.</source>
        <translation>Gran parte del objetivo no tiene el color aprendido: Mayús-clic en su lado claro y en su lado oscuro.</translation>
    </message>
    <message>
        <source>Cover objects of the same color, or take them out of view.</source>
        <translation>Cubra los objetos del mismo color o sáquelos de la imagen.</translation>
    </message>
    <message>
        <source>The target is nearly black here: more light would help.</source>
        <translation>El objetivo es casi negro aquí: más luz ayudaría.</translation>
    </message>
    <message>
        <source>The target is nearly white here: a shorter exposure would help.</source>
        <translation>El objetivo es casi blanco aquí: una exposición más corta ayudaría.</translation>
    </message>
    <message>
        <source>The target is nearly gray: a stronger color would help.</source>
        <translation>El objetivo es casi gris: un color más vivo ayudaría.</translation>
    </message>
    <message>
        <source>%1 % of the pixels have this color. Shift-click the target to see how well its color stands out.</source>
        <translation>El %1 % de los píxeles tiene este color. Mayús-clic en el objetivo muestra cuánto destaca su color.</translation>
    </message>
    <message>
        <source>This color also covers %1 % of the background.</source>
        <translation>También tiene este color el %1 % del fondo.</translation>
    </message>
    <message>
        <source>One sample hardly matches the learned color: the sample resembles its surroundings or shows another object.</source>
        <translation>Una muestra apenas coincide con el color aprendido: se parece a su entorno, o muestra otro objeto.</translation>
    </message>
    <message>
        <source>Several objects have this color: another color would help.</source>
        <translation>Varios objetos tienen este color: otro color ayudaría.</translation>
    </message>
    <message>
        <source>This color covers only %1 % of the target, and %2 % of the background.</source>
        <translation>Solo el %1 % del objetivo tiene este color, y el %2 % del fondo.</translation>
    </message>
    <message numerus="yes">
        <source>%n objects have this color and size: follow all of them, or cover the others.</source>
        <translation>
            <numerusform>%n objeto tiene este color y tamaño: sígalo o cubra los otros.</numerusform>
            <numerusform>%n objetos tienen este color y tamaño: sígalos todos o cubra los otros.</numerusform>
        </translation>
    </message>
    <message>
        <source>The color stands out well (%1 of 100 points).</source>
        <translation>El color destaca bien (%1 de 100 puntos).</translation>
    </message>
    <message>
        <source>The color stands out (%1 of 100 points).</source>
        <translation>El color destaca (%1 de 100 puntos).</translation>
    </message>
    <message>
        <source>The color is hard to tell from the background (%1 of 100 points).</source>
        <translation>El color es difícil de distinguir del fondo (%1 de 100 puntos).</translation>
    </message>
    <message>
        <source>The color hardly stands out (%1 of 100 points).</source>
        <translation>El color apenas destaca (%1 de 100 puntos).</translation>
    </message>
    <message>
        <source>The clicked region fills much of the image: click only the target, or drag a box around the target.</source>
        <translation>La región en la que hizo clic llena gran parte de la imagen: haga clic solo en el objetivo o arrastre un recuadro alrededor del objetivo.</translation>
    </message>
    <message>
        <source>You clicked only a speck: drag a box around the whole target.</source>
        <translation>Hizo clic solo en una mota: arrastre un recuadro alrededor de todo el objetivo.</translation>
    </message>
    <message>
        <source>A color range that covers the whole target would also cover %1 % of the background.</source>
        <translation>Un rango de color que abarque todo el objetivo abarcaría también el %1 % del fondo.</translation>
    </message>
    <message>
        <source>Other objects have this color too: Ctrl+Shift-click them to exclude them.</source>
        <translation>Otros objetos también tienen este color: Ctrl+Mayús+clic en ellos los excluye.</translation>
    </message>
    <message>
        <source>Almost nothing else in the images has this color.</source>
        <translation>Casi nada más en las imágenes tiene este color.</translation>
    </message>
    <message>
        <source>Only %1 % of the background has this color too, which is little compared with the target.</source>
        <translation>Solo el %1 % del fondo tiene también este color, poco en comparación con el objetivo.</translation>
    </message>
    <message>
        <source>Outside the target, the largest region of this color (%1) is in the image of %3, %2.</source>
        <translation>Fuera del objetivo, la zona más grande de este color (%1) está en la imagen de %3, %2.</translation>
    </message>
</context>
<context>
    <name>Convergence</name>
    <message>
        <source>Convergence</source>
        <translation>Convergencia</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>dispersión</translation>
    </message>
    <message>
        <source>Convergence in frame %1 (%2)</source>
        <comment>number of a frame, unit</comment>
        <translation>Convergencia en el fotograma %1 (%2)</translation>
    </message>
    <message>
        <source>Spread of the particles after each iteration on this frame. The filter has converged where the curve levels off.</source>
        <translation>Dispersión de las partículas tras cada iteración en este fotograma. El filtro ha convergido donde la curva se aplana.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>cannot be written</source>
        <translation>no se puede escribir</translation>
    </message>
    <message>
        <source>does not match the other data</source>
        <translation>no concuerda con los demás datos</translation>
    </message>
    <message>
        <source>ends earlier than expected</source>
        <translation>termina antes de lo previsto</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>ha fallado</translation>
    </message>
    <message>
        <source>not a usable value</source>
        <translation>valor no utilizable</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>detenido a petición</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>no se puede abrir la cámara</translation>
    </message>
    <message>
        <source>the camera stopped delivering images</source>
        <translation>la cámara dejó de entregar imágenes</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>no se puede leer el archivo</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>el archivo no existe</translation>
    </message>
    <message>
        <source>cannot be determined from the observations</source>
        <translation>no se puede determinar con las observaciones</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>no encontrado</translation>
    </message>
    <message>
        <source>this key is missing</source>
        <translation>falta esta clave</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>clave desconocida</translation>
    </message>
    <message>
        <source>wrong type of value</source>
        <translation>tipo de valor incorrecto</translation>
    </message>
    <message>
        <source>invalid format</source>
        <translation>formato no válido</translation>
    </message>
    <message>
        <source>the camera repeats images</source>
        <translation>la cámara repite imágenes</translation>
    </message>
    <message>
        <source>the camera sends fewer images than it should</source>
        <translation>la cámara envía menos imágenes de las que debería</translation>
    </message>
    <message>
        <source>the images are black</source>
        <translation>las imágenes están en negro</translation>
    </message>
    <message>
        <source>the images arrive late</source>
        <translation>las imágenes llegan con retraso</translation>
    </message>
    <message>
        <source>the images do not change</source>
        <translation>las imágenes no cambian</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>Barrera et al. 2005, figure 3: the particles projected into both cameras while the cloud finds the ball.</source>
        <translation>Barrera et al. 2005, figura 3: las partículas proyectadas en ambas cámaras mientras la nube encuentra la pelota.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 4: the particle cloud of figure 3 from above.</source>
        <translation>Barrera et al. 2005, figura 4: la nube de partículas de la figura 3 desde arriba.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 6: the object jumps 2 m at iteration 30.</source>
        <translation>Barrera et al. 2005, figura 6: el objeto salta 2 m en la iteración 30.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: with one camera, the cloud moves away from the camera.</source>
        <translation>Barrera et al. 2005, sección III-B: con una sola cámara, la nube se aleja de la cámara.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 5: where a single camera finds the color, and why the cloud moves away from the camera.</source>
        <translation>Barrera et al. 2005, figura 5: dónde encuentra el color una sola cámara y por qué la nube se aleja de la cámara.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009, figures 1 and 3: the regions that move in a camera&apos;s images, and the likelihood of a person at each pixel.</source>
        <translation>Mohedano et al. 2009, figuras 1 y 3: las zonas que se mueven en las imágenes de una cámara y la verosimilitud de una persona en cada píxel.</translation>
    </message>
    <message>
        <source>Drift of the estimate along the optical axis</source>
        <translation>Deriva de la estimación a lo largo del eje óptico</translation>
    </message>
    <message>
        <source>Error after a jump of the object</source>
        <translation>Error tras un salto del objeto</translation>
    </message>
    <message>
        <source>Particles from above</source>
        <translation>Partículas desde arriba</translation>
    </message>
    <message>
        <source>Particles in both camera images</source>
        <translation>Partículas en ambas imágenes de cámara</translation>
    </message>
    <message>
        <source>The particle cloud over time</source>
        <translation>La nube de partículas a lo largo del tiempo</translation>
    </message>
    <message>
        <source>Motion masks and motion likelihood</source>
        <translation>Máscaras de movimiento y verosimilitud del movimiento</translation>
    </message>
    <message>
        <source>Box tracking: error, success and precision</source>
        <translation>Seguimiento de recuadros: error, éxito y precisión</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet, stop and walk back.</source>
        <translation>Mohedano et al. 2009: dos personas se encuentran, se paran y regresan.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people walk close to each other.</source>
        <translation>Mohedano et al. 2009: dos personas caminan muy juntas.</translation>
    </message>
    <message>
        <source>People side by side</source>
        <translation>Personas una al lado de otra</translation>
    </message>
    <message>
        <source>People whose paths cross</source>
        <translation>Personas cuyos caminos se cruzan</translation>
    </message>
    <message>
        <source>People who enter and leave</source>
        <translation>Personas que entran y salen</translation>
    </message>
    <message>
        <source>People who meet and turn back</source>
        <translation>Personas que se encuentran y dan la vuelta</translation>
    </message>
    <message>
        <source>People who stay apart</source>
        <translation>Personas que se mantienen alejadas</translation>
    </message>
    <message>
        <source>Barrera et al. 2005: a ball in space</source>
        <translation>Barrera et al. 2005: una pelota en el espacio</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009: boxes in the images of one camera</source>
        <translation>Sugandi et al. 2009: recuadros en las imágenes de una cámara</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people</source>
        <translation>Mohedano et al. 2009: personas</translation>
    </message>
    <message>
        <source>More scenes of people</source>
        <translation>Más escenas con personas</translation>
    </message>
    <message>
        <source>People of different heights</source>
        <translation>Personas de distinta estatura</translation>
    </message>
    <message>
        <source>People who sit and crouch</source>
        <translation>Personas que se sientan y se agachan</translation>
    </message>
    <message>
        <source>One person sits down on a stool and rises, one crouches and rises, and one walks by.</source>
        <translation>Una persona se sienta en un taburete y se levanta, otra se agacha y se levanta, y otra pasa de largo.</translation>
    </message>
    <message>
        <source>People who carry objects</source>
        <translation>Personas que llevan objetos</translation>
    </message>
    <message>
        <source>Two people walk past each other, one with a box in front of the chest, one with a bag.</source>
        <translation>Dos personas se cruzan, una con una caja ante el pecho y otra con una bolsa.</translation>
    </message>
    <message>
        <source>A crowd</source>
        <translation>Una multitud</translation>
    </message>
    <message>
        <source>Five to eight people walk about for 12 s; their paths may touch and cross.</source>
        <translation>De cinco a ocho personas van y vienen durante 12 s; sus caminos pueden tocarse y cruzarse.</translation>
    </message>
    <message>
        <source>People seen by two cameras</source>
        <translation>Personas que ven dos cámaras</translation>
    </message>
    <message>
        <source>Two people walk past each other, seen by only two of the four cameras.</source>
        <translation>Dos personas se cruzan; solo las ven dos de las cuatro cámaras.</translation>
    </message>
    <message>
        <source>Two people come within 0.15 to 0.28 m of each other, stand there, and go back.</source>
        <translation>Dos personas se acercan a entre 0,15 y 0,28 m, se paran y vuelven atrás.</translation>
    </message>
    <message>
        <source>Furniture that moves</source>
        <translation>Muebles que se mueven</translation>
    </message>
    <message>
        <source>A cabinet and a stool are moved after the cameras have learned the background.</source>
        <translation>Un armario y un taburete se mueven después de que las cámaras hayan aprendido el fondo.</translation>
    </message>
    <message>
        <source>Clothes in the room&apos;s colors</source>
        <translation>Ropa con los colores de la sala</translation>
    </message>
    <message>
        <source>Two people whose clothes have the colors of walls, furniture and floor walk past each other.</source>
        <translation>Se cruzan dos personas con ropa de los colores de las paredes, los muebles y el suelo.</translation>
    </message>
    <message>
        <source>Patterned clothes</source>
        <translation>Ropa estampada</translation>
    </message>
    <message>
        <source>Two people in striped, checked or blotched shirts walk past each other.</source>
        <translation>Se cruzan dos personas con camisas de rayas, de cuadros o de manchas.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 7: the error after the jump of figure 6, for motion sigmas from 0.001 to 0.3 m, drawn as an image.</source>
        <translation>Barrera et al. 2005, figura 7: el error tras el salto de la figura 6 para sigmas de movimiento de 0,001 a 0,3 m, dibujado como imagen.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 8: the cloud in six iterations, with a small and with a large motion sigma.</source>
        <translation>Barrera et al. 2005, figura 8: la nube en seis iteraciones, con una sigma de movimiento pequeña y con una grande.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: the share of runs that converge, for start volumes of different sizes, and for start points at different distances behind the ball.</source>
        <translation>Barrera et al. 2005, sección III-B: la proporción de ejecuciones que convergen, con volúmenes iniciales de distintos tamaños y con puntos iniciales a distintas distancias detrás de la pelota.</translation>
    </message>
    <message>
        <source>Error after each iteration, for different motion sigmas</source>
        <translation>Error tras cada iteración, con distintas sigmas de movimiento</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people enter and leave. Measures how long an estimate exists where nobody is, and how long a person has no estimate.</source>
        <translation>Mohedano et al. 2009: la gente entra y sale. Mide cuánto tiempo hay una estimación donde no hay nadie, y cuánto tiempo una persona no tiene estimación.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people far apart. This is the easy case: no method should mix them up.</source>
        <translation>Mohedano et al. 2009: dos personas lejos una de la otra. Es el caso fácil: ningún método debería confundirlas.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet and walk on. A method that uses only motion may mix them up; color tells them apart if their clothes differ.</source>
        <translation>Mohedano et al. 2009: dos personas se encuentran y siguen. Un método que solo usa el movimiento puede confundirlas; el color las distingue si su ropa es distinta.</translation>
    </message>
    <message>
        <source>People who come close to each other</source>
        <translation>Personas que se acercan entre sí</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009, section 4: compares method sugandi with 100 and with 300 particles, method histogram, and four trackers of OpenCV, all on the same clips.</source>
        <translation>Sugandi et al. 2009, sección 4: compara el método sugandi con 100 y con 300 partículas, el método histogram y cuatro seguidores de OpenCV, todos en los mismos vídeos.</translation>
    </message>
    <message>
        <source>Three people walk about: a child 0.9 to 1.3 m tall, a person 1.3 to 1.6 m tall and a person 1.88 to 2 m tall.</source>
        <translation>Tres personas caminan por la sala: un niño de 0,9 a 1,3 m de altura, una persona de 1,3 a 1,6 m y otra de 1,88 a 2 m.</translation>
    </message>
    <message>
        <source>Where a single camera finds the color</source>
        <translation>Dónde encuentra el color una sola cámara</translation>
    </message>
    <message>
        <source>From which starting positions the particles still find the target</source>
        <translation>Desde qué posiciones iniciales las partículas aún encuentran el objetivo</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>CSV, one row per target and time</source>
        <translation>CSV, una fila por objetivo e instante</translation>
    </message>
    <message>
        <source>CSV, one row per time (spreadsheets)</source>
        <translation>CSV, una fila por instante (hojas de cálculo)</translation>
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
        <translation>C3D (captura de movimiento)</translation>
    </message>
    <message>
        <source>NPZ (NumPy)</source>
        <translation>NPZ (NumPy)</translation>
    </message>
    <message>
        <source>VTP (ParaView, paths)</source>
        <translation>VTP (ParaView, trayectorias)</translation>
    </message>
    <message>
        <source>PVD (ParaView, over time)</source>
        <translation>PVD (ParaView, en el tiempo)</translation>
    </message>
    <message>
        <source>JSON lines</source>
        <translation>Líneas JSON</translation>
    </message>
    <message>
        <source>Z points up, axes as in the project</source>
        <translation>Z apunta hacia arriba, ejes como en el proyecto</translation>
    </message>
    <message>
        <source>Lengths in %1, times in s, covariances in %1². %2.</source>
        <translation>Longitudes en %1, tiempos en s, covarianzas en %1². %2.</translation>
    </message>
    <message>
        <source>no gaps</source>
        <translation>sin huecos</translation>
    </message>
    <message>
        <source>%1 positions unknown</source>
        <translation>%1 posiciones desconocidas</translation>
    </message>
    <message>
        <source>Targets: %1, rows: %2 at %3 per second, %4.</source>
        <translation>Objetivos: %1, filas: %2 a %3 por segundo, %4.</translation>
    </message>
    <message>
        <source>Y points up: x, y, z of the file are y, z, x of the project</source>
        <translation>Y apunta hacia arriba: x, y, z del archivo son y, z, x del proyecto</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Wrote the figure %1.</source>
        <translation>Se escribió la figura %1.</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2 files; the last is %3.</source>
        <translation>Se exportaron %1 filas a %2 archivos; el último es %3.</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2.</source>
        <translation>Se exportaron %1 filas a %2.</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 y %2 tienen la misma pose.</translation>
    </message>
    <message>
        <source>%1 has %2 frames of %3 pixels, %4.</source>
        <translation>%1 tiene %2 fotogramas de %3 píxeles, %4.</translation>
    </message>
    <message>
        <source>%1 is %2 m below the floor (z = 0).</source>
        <translation>%1 está %2 m por debajo del suelo (z = 0).</translation>
    </message>
    <message>
        <source>The view of %1 does not overlap with the view of any other camera.</source>
        <translation>El campo de %1 no se solapa con el de ninguna otra cámara.</translation>
    </message>
    <message>
        <source>A file of the project is missing: %1.</source>
        <translation>Falta un archivo del proyecto: %1.</translation>
    </message>
    <message>
        <source>According to their tables of times, the cameras never recorded at the same time.</source>
        <translation>Según sus tablas de tiempos, las cámaras nunca grabaron al mismo tiempo.</translation>
    </message>
    <message>
        <source>Add a target, or choose a method that finds targets by itself.</source>
        <translation>Añada un objetivo o elija un método que los encuentre por sí mismo.</translation>
    </message>
    <message>
        <source>Add cameras, or choose another method.</source>
        <translation>Añada cámaras o elija otro método.</translation>
    </message>
    <message>
        <source>Calibrate both cameras again; the pose of one was probably copied from the other.</source>
        <translation>Calibre ambas cámaras de nuevo; probablemente la pose de una se copió de la otra.</translation>
    </message>
    <message>
        <source>Calibrate the cameras with a board, a wand or measured points.</source>
        <translation>Calibre las cámaras con un tablero, una varita o puntos medidos.</translation>
    </message>
    <message>
        <source>Calibrate the cameras, or choose a method that tracks boxes in images.</source>
        <translation>Calibre las cámaras o elija un método que siga recuadros en imágenes.</translation>
    </message>
    <message>
        <source>In the project file, check the value of late_by for this camera. It is in seconds.</source>
        <translation>En el archivo del proyecto, compruebe el valor de late_by de esta cámara. Está en segundos.</translation>
    </message>
    <message>
        <source>Check that the camera sees the target, and check its exposure and white balance.</source>
        <translation>Compruebe que la cámara vea el objetivo, y también su exposición y su balance de blancos.</translation>
    </message>
    <message>
        <source>Check that the time stamps of all cameras (in their tables of times) are from the same clock.</source>
        <translation>Compruebe que las marcas de tiempo de todas las cámaras (en sus tablas de tiempos) proceden del mismo reloj.</translation>
    </message>
    <message>
        <source>Check that the corrections were made for this recording.</source>
        <translation>Compruebe que las correcciones se hicieron para esta grabación.</translation>
    </message>
    <message>
        <source>Check that z points up and is 0 on the floor, unless you placed the origin elsewhere.</source>
        <translation>Compruebe que z apunte hacia arriba y sea 0 en el suelo, a menos que haya puesto el origen en otro sitio.</translation>
    </message>
    <message>
        <source>Click the target in an image, or use the command learn-color.</source>
        <translation>Haga clic en el objetivo en una imagen o use la orden learn-color.</translation>
    </message>
    <message>
        <source>Convert the recordings to the same frame rate, or give each camera a table of times.</source>
        <translation>Convierta las grabaciones a una misma frecuencia o indique una tabla de tiempos para cada cámara.</translation>
    </message>
    <message>
        <source>Copy the recording again, or convert it with FFmpeg.</source>
        <translation>Copie la grabación de nuevo o conviértala con FFmpeg.</translation>
    </message>
    <message>
        <source>Copy the video again, or repair it with FFmpeg (ffmpeg -i IN -c copy OUT).</source>
        <translation>Copie el vídeo de nuevo o repárelo con FFmpeg (ffmpeg -i ENTRADA -c copy SALIDA).</translation>
    </message>
    <message>
        <source>Copy the image folder again; otherwise the camera has no image in the missing frames.</source>
        <translation>Copie de nuevo la carpeta de imágenes; si no, la cámara no tendrá imagen en los fotogramas que faltan.</translation>
    </message>
    <message>
        <source>Copy the recording again, or use only the frames before the unreadable one.</source>
        <translation>Copie de nuevo la grabación o use solo los fotogramas anteriores al ilegible.</translation>
    </message>
    <message>
        <source>In the project file, correct the value of late_by for this camera. It is in seconds.</source>
        <translation>En el archivo del proyecto, corrija el valor de late_by de esta cámara. Está en segundos.</translation>
    </message>
    <message>
        <source>Correct the file of true positions, or remove the key &apos;truth&apos; from the project file.</source>
        <translation>Corrija el archivo de posiciones verdaderas o quite la clave «truth» del archivo del proyecto.</translation>
    </message>
    <message>
        <source>Correct the project file in a text editor, or make a new project.</source>
        <translation>Corrija el archivo del proyecto en un editor de texto o cree un proyecto nuevo.</translation>
    </message>
    <message>
        <source>Correct the table of times, or remove this camera&apos;s key &apos;times&apos; from the project file.</source>
        <translation>Corrija la tabla de tiempos o quite la clave «times» de esta cámara del archivo del proyecto.</translation>
    </message>
    <message>
        <source>The project has corrections for frames that the recording does not have: %1.</source>
        <translation>El proyecto tiene correcciones para fotogramas que la grabación no tiene: %1.</translation>
    </message>
    <message>
        <source>Draw the box in an earlier frame.</source>
        <translation>Dibuje el recuadro en un fotograma anterior.</translation>
    </message>
    <message>
        <source>Draw a box around the target in an image.</source>
        <translation>Dibuje un recuadro alrededor del objetivo en una imagen.</translation>
    </message>
    <message>
        <source>Frame %2 of %1 cannot be read: %3.</source>
        <translation>No se puede leer el fotograma %2 de %1: %3.</translation>
    </message>
    <message>
        <source>Give a table of times to every camera, or to none.</source>
        <translation>Indique una tabla de tiempos para todas las cámaras o para ninguna.</translation>
    </message>
    <message>
        <source>Give the radius in meters.</source>
        <translation>Indique el radio en metros.</translation>
    </message>
    <message>
        <source>Import the calibration again, or calibrate the cameras again.</source>
        <translation>Importe la calibración de nuevo o calibre otra vez las cámaras.</translation>
    </message>
    <message>
        <source>Import the calibration again with the right unit (calibration convert --unit).</source>
        <translation>Importe de nuevo la calibración con la unidad correcta (calibration convert --unit).</translation>
    </message>
    <message>
        <source>In the first %1 s, the images do not fit the calibration: %2.</source>
        <translation>En los primeros %1 s, las imágenes no encajan con la calibración: %2.</translation>
    </message>
    <message>
        <source>Judging by the numbers in the file names, %2 of %3 images of %1 are missing, the first one after %4.</source>
        <translation>Según los números de los nombres de archivo, faltan imágenes de %1 (%2 de %3); la primera, después de %4.</translation>
    </message>
    <message>
        <source>Learn the color again in an image of this recording.</source>
        <translation>Aprenda el color de nuevo en una imagen de esta grabación.</translation>
    </message>
    <message>
        <source>Learn the color again, with samples that do not reach beyond the target.</source>
        <translation>Aprenda el color de nuevo, con muestras que no se salgan del objetivo.</translation>
    </message>
    <message>
        <source>Learn the color again.</source>
        <translation>Aprenda el color de nuevo.</translation>
    </message>
    <message>
        <source>Make one project of the live cameras and another one of the recordings.</source>
        <translation>Cree un proyecto con las cámaras en vivo y otro con las grabaciones.</translation>
    </message>
    <message>
        <source>Free some disk space, or write to another disk with the option --out.</source>
        <translation>Libere espacio o escriba en otro disco con la opción --out.</translation>
    </message>
    <message>
        <source>Move the volume of interest, or remove it.</source>
        <translation>Mueva el volumen de interés o quítelo.</translation>
    </message>
    <message>
        <source>No part of the volume of interest is seen by enough cameras (at least %1 are needed).</source>
        <translation>Ninguna parte del volumen de interés está a la vista de suficientes cámaras (se necesitan al menos %1).</translation>
    </message>
    <message>
        <source>No pixel can have the color of target %1: the color range is too narrow.</source>
        <translation>Ningún píxel puede tener el color del objetivo %1: el rango de color es demasiado estrecho.</translation>
    </message>
    <message>
        <source>Nothing can be tracked: %1.</source>
        <translation>No se puede seguir nada: %1.</translation>
    </message>
    <message>
        <source>Nothing can be written to the folder of the project.</source>
        <translation>No se puede escribir en la carpeta del proyecto.</translation>
    </message>
    <message>
        <source>Only %1 GB are free for results.</source>
        <translation>Solo hay %1 GB libres para los resultados.</translation>
    </message>
    <message>
        <source>Only %1 MB are free for results.</source>
        <translation>Solo hay %1 MB libres para los resultados.</translation>
    </message>
    <message>
        <source>Only the first %2 frames of each recording are used; check that all recordings begin at the same time.</source>
        <translation>Solo se usan los primeros %2 fotogramas de cada grabación; compruebe que todas empiecen al mismo tiempo.</translation>
    </message>
    <message>
        <source>Open the project to see whether images arrive.</source>
        <translation>Abra el proyecto para ver si llegan imágenes.</translation>
    </message>
    <message>
        <source>Other cameras have a table of times, but %1 has none.</source>
        <translation>Otras cámaras tienen una tabla de tiempos, pero %1 no.</translation>
    </message>
    <message>
        <source>Connect the device, or choose another one.</source>
        <translation>Conecte el dispositivo o elija otro.</translation>
    </message>
    <message>
        <source>Put the missing file or folder back, or correct its path in the project file.</source>
        <translation>Devuelva a su sitio el archivo o la carpeta que falta, o corrija la ruta en el archivo del proyecto.</translation>
    </message>
    <message>
        <source>Remove frames_per_second from the project file, unless the rate stated in the video is wrong.</source>
        <translation>Quite frames_per_second del archivo del proyecto, a menos que el dato del vídeo sea erróneo.</translation>
    </message>
    <message>
        <source>Set frames_per_second in the project file; the measured speeds depend on it.</source>
        <translation>Defina frames_per_second en el archivo del proyecto; las velocidades medidas dependen de ello.</translation>
    </message>
    <message>
        <source>In the project file, set the key &apos;rotate&apos; of this camera to 90 or 270.</source>
        <translation>En el archivo del proyecto, ponga la clave «rotate» de esta cámara a 90 o 270.</translation>
    </message>
    <message>
        <source>Simulated cameras: %1.</source>
        <translation>Cámaras simuladas: %1.</translation>
    </message>
    <message>
        <source>Solve this problem, then check again.</source>
        <translation>Resuelva el problema indicado y compruebe de nuevo.</translation>
    </message>
    <message>
        <source>Some cameras are live and others are recordings.</source>
        <translation>Algunas cámaras son en vivo y otras son grabaciones.</translation>
    </message>
    <message>
        <source>Take the background image again, or remove this camera&apos;s key &apos;empty_room&apos; from the project file.</source>
        <translation>Tome de nuevo la imagen de fondo o quite la clave «empty_room» de esta cámara del archivo del proyecto.</translation>
    </message>
    <message>
        <source>Target %1 has a radius of %2 m, which is larger than a person.</source>
        <translation>El objetivo %1 tiene un radio de %2 m: sería más grande que una persona.</translation>
    </message>
    <message>
        <source>Target %1 has no box to start from.</source>
        <translation>El objetivo %1 no tiene ningún recuadro desde el que empezar.</translation>
    </message>
    <message>
        <source>Target %1 has no color yet.</source>
        <translation>El objetivo %1 aún no tiene color.</translation>
    </message>
    <message>
        <source>The background image of %1 cannot be used: %2.</source>
        <translation>La imagen de fondo de %1 no se puede usar: %2.</translation>
    </message>
    <message>
        <source>The box of target %1 is in frame %2, but the last frame is frame %3.</source>
        <translation>El recuadro del objetivo %1 está en el fotograma %2, pero el último fotograma es el %3.</translation>
    </message>
    <message>
        <source>The calibration cannot be right: %1.</source>
        <translation>La calibración no puede ser correcta: %1.</translation>
    </message>
    <message>
        <source>The calibration is plausible (cameras: %1, largest distance between them: %2 m).</source>
        <translation>La calibración es plausible (cámaras: %1, distancia máxima: %2 m).</translation>
    </message>
    <message>
        <source>The cameras are %1 m apart: their positions are probably in units of %2 m.</source>
        <translation>Las cámaras están a %1 m unas de otras: probablemente sus posiciones están en unidades de %2 m.</translation>
    </message>
    <message>
        <source>The cameras are not calibrated: their poses are guesses, so tracked positions mean nothing.</source>
        <translation>Las cámaras no están calibradas: sus poses son solo supuestas, así que las posiciones seguidas no significan nada.</translation>
    </message>
    <message>
        <source>In the images of %3, %2 % of all pixels have the color of target %1.</source>
        <translation>En las imágenes de %3, el %2 % de todos los píxeles tiene el color del objetivo %1.</translation>
    </message>
    <message>
        <source>In the images, %2 % of all pixels have the color of target %1.</source>
        <translation>En las imágenes, el %2 % de todos los píxeles tiene el color del objetivo %1.</translation>
    </message>
    <message>
        <source>The color of target %1 was not found in any of the %2 checked images.</source>
        <translation>El color del objetivo %1 no se encontró en ninguna de las %2 imágenes examinadas.</translation>
    </message>
    <message>
        <source>The color of target %1 was not found in any of the checked images of %2.</source>
        <translation>El color del objetivo %1 no se encontró en ninguna de las imágenes examinadas de %2.</translation>
    </message>
    <message>
        <source>The delay of %1 is %2 s, which is unusually large.</source>
        <translation>El retraso de %1 es de %2 s, un valor inusualmente grande.</translation>
    </message>
    <message>
        <source>The delay of %1 (%2 s) is longer than its recording, so this camera has no image in any frame.</source>
        <translation>El retraso de %1 (%2 s) es más largo que su grabación, así que esta cámara no tiene imagen en ningún fotograma.</translation>
    </message>
    <message>
        <source>The device of %1 is connected.</source>
        <translation>El dispositivo de %1 está conectado.</translation>
    </message>
    <message>
        <source>The device of %1 is not connected: %2.</source>
        <translation>El dispositivo de %1 no está conectado: %2.</translation>
    </message>
    <message>
        <source>The frame rate of the images is not given; %1 frames per second are assumed.</source>
        <translation>La frecuencia de las imágenes no está indicada en ningún sitio; se suponen %1 por segundo.</translation>
    </message>
    <message>
        <source>The images of %1 have %2 pixels, but its calibration is for %3.</source>
        <translation>Las imágenes de %1 tienen %2 píxeles, pero su calibración es para %3.</translation>
    </message>
    <message>
        <source>The method %1 can work with this project.</source>
        <translation>El método %1 puede trabajar con este proyecto.</translation>
    </message>
    <message>
        <source>The method %1 needs at least %2 cameras; this project has %3.</source>
        <translation>El método %1 necesita al menos %2 cámaras; hay %3.</translation>
    </message>
    <message>
        <source>The method %1 needs calibrated cameras.</source>
        <translation>El método %1 necesita cámaras calibradas.</translation>
    </message>
    <message>
        <source>The project can be read.</source>
        <translation>El proyecto se puede leer.</translation>
    </message>
    <message>
        <source>The project cannot be opened: %1.</source>
        <translation>No se puede abrir el proyecto: %1.</translation>
    </message>
    <message>
        <source>The project cannot be read: %1.</source>
        <translation>No se puede leer el proyecto: %1.</translation>
    </message>
    <message>
        <source>The project says %1 frames per second, but the video of %2 has %3.</source>
        <translation>El proyecto indica %1 fotogramas por segundo, pero el vídeo de %2 tiene %3.</translation>
    </message>
    <message>
        <source>The recording of %1 cannot be opened: %2.</source>
        <translation>No se puede abrir la grabación de %1: %2.</translation>
    </message>
    <message>
        <source>The recording of %1 is missing: %2.</source>
        <translation>Falta la grabación de %1: %2.</translation>
    </message>
    <message>
        <source>The recordings differ in length: %1.</source>
        <translation>Las grabaciones tienen distinta longitud: %1.</translation>
    </message>
    <message>
        <source>The recordings have different frame rates: %1.</source>
        <translation>Las grabaciones tienen distinta frecuencia de fotogramas: %1.</translation>
    </message>
    <message>
        <source>The stream of %1 was not tested: the check opens no network connections.</source>
        <translation>El flujo de %1 no se ha probado: la comprobación no abre conexiones de red.</translation>
    </message>
    <message>
        <source>The table of times of %1 cannot be used: %2.</source>
        <translation>La tabla de tiempos de %1 no se puede usar: %2.</translation>
    </message>
    <message>
        <source>The table of times of %1 has %2 times, but there are %3 images.</source>
        <translation>La tabla de tiempos de %1 tiene %2 tiempos, pero hay %3 imágenes.</translation>
    </message>
    <message>
        <source>The true positions cannot be read: %1.</source>
        <translation>No se pueden leer las posiciones verdaderas: %1.</translation>
    </message>
    <message>
        <source>The video of %1 is cut off: %2.</source>
        <translation>El vídeo de %1 está cortado: %2.</translation>
    </message>
    <message>
        <source>There is enough disk space for results: %1 GB are free.</source>
        <translation>Hay suficiente espacio en disco para los resultados: %1 GB libres.</translation>
    </message>
    <message>
        <source>Turn this camera toward the target, or calibrate it again.</source>
        <translation>Gire esta cámara hacia el objetivo o calíbrela de nuevo.</translation>
    </message>
    <message>
        <source>Use a calibration for images of this size, or record images of the calibrated size.</source>
        <translation>Use una calibración para imágenes de este tamaño, o grabe imágenes del tamaño calibrado.</translation>
    </message>
    <message>
        <source>Use the table of times that belongs to this recording.</source>
        <translation>Use la tabla de tiempos que corresponde a esta grabación.</translation>
    </message>
    <message>
        <source>Write the results to another folder with the option --out.</source>
        <translation>Escriba los resultados en otra carpeta con la opción --out.</translation>
    </message>
    <message>
        <source>When the color of target %1 was learned, %2 % of its pixels in %3 were overexposed.</source>
        <translation>Cuando se aprendió el color del objetivo %1, el %2 % de sus píxeles en %3 estaba sobreexpuesto.</translation>
    </message>
    <message>
        <source>When the color of target %1 was learned, %2 % of its pixels in %3 were too dark.</source>
        <translation>Cuando se aprendió el color del objetivo %1, el %2 % de sus píxeles en %3 estaba demasiado oscuro.</translation>
    </message>
    <message>
        <source>Lower the exposure of the camera, and learn the color again in new images.</source>
        <translation>Reduzca la exposición de la cámara y vuelva a aprender el color en imágenes nuevas.</translation>
    </message>
    <message>
        <source>Raise the exposure of the camera or add light, and learn the color again in new images.</source>
        <translation>Aumente la exposición de la cámara o añada luz, y vuelva a aprender el color en imágenes nuevas.</translation>
    </message>
</context>
<context>
    <name>FindingText</name>
    <message>
        <source>camera “%1”</source>
        <translation>cámara «%1»</translation>
    </message>
</context>
<context>
    <name>GlContext</name>
    <message>
        <source>no OpenGL context can be made on this display</source>
        <translation>no se puede crear un contexto OpenGL en esta pantalla</translation>
    </message>
    <message>
        <source>the OpenGL context cannot be used</source>
        <translation>no se puede usar el contexto OpenGL</translation>
    </message>
    <message>
        <source>OpenGL 3.2 is needed</source>
        <translation>se necesita OpenGL 3.2</translation>
    </message>
</context>
<context>
    <name>GuideText</name>
    <message>
        <source>guessed</source>
        <translation>supuesta</translation>
    </message>
    <message>
        <source>exact (simulated)</source>
        <translation>exacta (simulada)</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>a mano</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>puntos medidos</translation>
    </message>
    <message>
        <source>board</source>
        <translation>tablero</translation>
    </message>
    <message>
        <source>wand</source>
        <translation>varita</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>de un archivo</translation>
    </message>
    <message>
        <source>points marked in the images</source>
        <translation>puntos marcados en las imágenes</translation>
    </message>
    <message>
        <source>%1, ±%2</source>
        <translation>%1, ±%2</translation>
    </message>
    <message>
        <source>By hand: fit a drawn grid to the images</source>
        <translation>A mano: ajustar una cuadrícula dibujada a las imágenes</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Puntos medidos</translation>
    </message>
    <message>
        <source>Printed board</source>
        <translation>Tablero impreso</translation>
    </message>
    <message>
        <source>Wand: a ball, or a stick with two balls</source>
        <translation>Varita: una pelota, o un palo con dos pelotas</translation>
    </message>
    <message>
        <source>File of another program</source>
        <translation>Archivo de otro programa</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Import the file</source>
        <translation>Importar el archivo</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Importar calibración…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>Print a board</source>
        <translation>Imprimir un tablero</translation>
    </message>
    <message>
        <source>Go to the page Board</source>
        <translation>Ir a la página Tablero</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>Lentes</translation>
    </message>
    <message>
        <source>Calibrate the lenses</source>
        <translation>Calibrar las lentes</translation>
    </message>
    <message>
        <source>Set the field of view</source>
        <translation>Indicar el campo de visión</translation>
    </message>
    <message>
        <source>Go to the page By hand</source>
        <translation>Ir a la página A mano</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Lay the grid over the room</source>
        <translation>Colocar la cuadrícula sobre la sala</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Measure points and click them</source>
        <translation>Medir puntos y hacer clic en ellos</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posiciones</translation>
    </message>
    <message>
        <source>Compute the cameras</source>
        <translation>Calcular las cámaras</translation>
    </message>
    <message>
        <source>Find the camera positions</source>
        <translation>Encontrar las posiciones de las cámaras</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Aprox.</translation>
    </message>
    <message>
        <source>Place the cameras roughly</source>
        <translation>Colocar las cámaras aproximadamente</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Pelota</translation>
    </message>
    <message>
        <source>Learn the color of the ball</source>
        <translation>Aprender el color de la pelota</translation>
    </message>
    <message>
        <source>Click the ball in an image. For a stick with two balls, learn two targets of different colors.</source>
        <translation>Haga clic en la pelota en una imagen. Para un palo con dos pelotas, aprenda dos objetivos de colores distintos.</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>Aprender color</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>Agitar</translation>
    </message>
    <message>
        <source>Wave the wand</source>
        <translation>Agitar la varita</translation>
    </message>
    <message>
        <source>Go to the page Wand</source>
        <translation>Ir a la página Varita</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Set floor and origin</source>
        <translation>Fijar suelo y origen</translation>
    </message>
    <message>
        <source>Go to the page Floor</source>
        <translation>Ir a la página Suelo</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Check a measured length</source>
        <translation>Comprobar una longitud medida</translation>
    </message>
    <message>
        <source>Not done yet.</source>
        <translation>Aún no hecho.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Hecho.</translation>
    </message>
    <message>
        <source>the z axis does not seem to point up</source>
        <translation>el eje z no parece apuntar hacia arriba</translation>
    </message>
    <message>
        <source>%1, ±%2: too inaccurate</source>
        <translation>%1, ±%2: demasiado impreciso</translation>
    </message>
    <message>
        <source>You need one known length, such as the length of a table or of a floor tile. You get a first result within minutes.</source>
        <translation>Necesita una longitud conocida, por ejemplo la de una mesa o una baldosa del suelo. Obtiene un primer resultado en minutos.</translation>
    </message>
    <message>
        <source>You need a printed board that you can carry through the room. This is the most accurate way to calibrate the lenses.</source>
        <translation>Necesita un tablero impreso que pueda llevar por la sala. Es la forma más exacta de calibrar las lentes.</translation>
    </message>
    <message>
        <source>You need rough camera positions and a ball to wave. This is the most accurate way to find the camera positions in a large room.</source>
        <translation>Necesita posiciones aproximadas de las cámaras y una pelota para agitar. Es la forma más exacta de hallar las posiciones de las cámaras en una sala grande.</translation>
    </message>
    <message>
        <source>You need a calibration file for these cameras and for images of this size.</source>
        <translation>Necesita un archivo de calibración para estas cámaras y para imágenes de este tamaño.</translation>
    </message>
    <message>
        <source>Choose the file. If something is missing in the file, such as the unit, the dialog asks you for it. The dialog also shows how far each camera would move.</source>
        <translation>Elija el archivo. Si falta algo en él, por ejemplo la unidad, el cuadro de diálogo se lo pregunta. También muestra cuánto se movería cada cámara.</translation>
    </message>
    <message>
        <source>Describe the board on the page Board, and print it at 100 %. Check the scale bar with a ruler, and glue the sheet to something stiff and flat. If you already have a board, just describe it and go on to the next step.</source>
        <translation>Describa el tablero en la página Tablero e imprímalo al 100 %. Compruebe la barra de escala con una regla y pegue la hoja a algo rígido y plano. Si ya tiene un tablero, solo descríbalo y pase al paso siguiente.</translation>
    </message>
    <message>
        <source>On the page Board, choose Intrinsics. With live cameras, press Start and show the board to each camera: close, tilted to all sides, and in the corners of the image. Hold it still each time. If you have already recorded this, just press Calibrate.</source>
        <translation>En la página Tablero, elija Parámetros intrínsecos. Con cámaras en vivo, pulse Empezar y muestre el tablero a cada cámara: de cerca, inclinado hacia todos los lados y en las esquinas de la imagen. Manténgalo quieto cada vez. Si ya lo ha grabado, solo pulse Calibrar.</translation>
    </message>
    <message>
        <source>Enter the field of view or the focal length of each camera, for example from its data sheet. Calibrating the lens with a board is more accurate, but you do not need it to begin.</source>
        <translation>Introduzca el campo de visión o la distancia focal de cada cámara, por ejemplo de su hoja de datos. Calibrar la lente con un tablero es más exacto, pero no lo necesita para empezar.</translation>
    </message>
    <message>
        <source>Give the grid the size of a real object that you have measured. In each image, drag the grid until it lies on this object. Click a point of the grid to hold it in place.</source>
        <translation>Dé a la cuadrícula el tamaño de un objeto real que haya medido. En cada imagen, arrastre la cuadrícula hasta que coincida con ese objeto. Haga clic en un punto de la cuadrícula para fijarlo.</translation>
    </message>
    <message>
        <source>Add points whose positions in the room you have measured, in meters. Then click each point in the images. Each camera needs at least four points, or better six that do not all lie in one plane.</source>
        <translation>Añada puntos cuyas posiciones en la sala haya medido, en metros. Después haga clic en cada punto en las imágenes. Cada cámara necesita al menos cuatro puntos, o mejor seis que no estén todos en un mismo plano.</translation>
    </message>
    <message>
        <source>Press Compute cameras below the table of points. If a point fits badly, the page tells you which one.</source>
        <translation>Pulse Calcular cámaras debajo de la tabla de puntos. Si un punto encaja mal, la página le dice cuál es.</translation>
    </message>
    <message>
        <source>On the page Board, choose Camera positions. With live cameras, press Start and show the board to at least two cameras at a time, in many parts of the volume. Lay it on the floor once, and press Set floor from board. If you have already recorded this, enter the frame with the board on the floor and press Calibrate.</source>
        <translation>En la página Tablero, elija Posiciones de las cámaras. Con cámaras en vivo, pulse Empezar y muestre el tablero a al menos dos cámaras a la vez, en muchas partes del volumen. Póngalo una vez en el suelo y pulse Fijar suelo con tablero. Si ya lo ha grabado, indique el fotograma con el tablero en el suelo y pulse Calibrar.</translation>
    </message>
    <message>
        <source>Drag the grid in each image, or the cameras in the bird&apos;s-eye view, until each camera is within about 12 cm of its real position.</source>
        <translation>Arrastre la cuadrícula en cada imagen, o las cámaras en la vista de pájaro, hasta que cada cámara esté a menos de unos 12 cm de su posición real.</translation>
    </message>
    <message>
        <source>On the page Wand, choose what you wave and where the scale comes from. With live cameras, press Start waving and wave slowly through the whole volume for half a minute. Then press Refine cameras. If you have already recorded this, just press Refine cameras.</source>
        <translation>En la página Varita, indique qué agita y de dónde viene la escala. Con cámaras en vivo, pulse Empezar a agitar y agite despacio por todo el volumen durante medio minuto. Después pulse Refinar cámaras. Si ya lo ha grabado, solo pulse Refinar cámaras.</translation>
    </message>
    <message>
        <source>Mark three points of the floor as A, B and C, each in at least two images. A becomes the origin, and the x axis points from A to B. Then press Set floor from A, B and C.</source>
        <translation>Marque tres puntos del suelo como A, B y C, cada uno en al menos dos imágenes. A será el origen y el eje x apunta de A a B. Después pulse Definir suelo con A, B y C.</translation>
    </message>
    <message>
        <source>Measure a distance in the room, as long as possible. Mark its ends as A and B, enter the distance, and press Check. If the calibration gives a different distance, press Set scale to correct the calibration.</source>
        <translation>Mida una distancia en la sala, lo más larga posible. Marque sus extremos como A y B, introduzca la distancia y pulse Comprobar. Si la calibración da otra distancia, pulse Definir escala para corregir la calibración.</translation>
    </message>
    <message>
        <source>Done: the distance in the calibration differs from the measured one by %1.</source>
        <translation>Hecho: la distancia de la calibración difiere en %1 de la medida.</translation>
    </message>
    <message>
        <source>Done for %1 of %2 cameras.</source>
        <translation>Hecho en %1 de %2 cámaras.</translation>
    </message>
    <message>
        <source>Done for %1 of %2 cameras. The largest error is %3.</source>
        <translation>Hecho en %1 de %2 cámaras. El error máximo es %3.</translation>
    </message>
    <message>
        <source>You need a tape measure and points that the cameras see: at least four for each camera, better six. Choose this for cameras that are mounted in a room.</source>
        <translation>Necesita una cinta métrica y puntos que vean las cámaras: al menos cuatro para cada cámara, mejor seis. Elija esta forma para cámaras montadas en una sala.</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>%1 or more</source>
        <translation>%1 o más</translation>
    </message>
    <message>
        <source>blank: seen by fewer than two cameras</source>
        <translation>vacío: lo ven menos de dos cámaras</translation>
    </message>
    <message>
        <source>Cameras that see a point</source>
        <translation>Cámaras que ven un punto</translation>
    </message>
    <message>
        <source>Expected error (1 σ)</source>
        <translation>Error esperado (1 σ)</translation>
    </message>
    <message>
        <source>blank: seen by no camera</source>
        <translation>vacío: no lo ve ninguna cámara</translation>
    </message>
</context>
<context>
    <name>MapOverlay</name>
    <message>
        <source>Cameras that see this point: %1</source>
        <translation>Cámaras que ven este punto: %1</translation>
    </message>
    <message>
        <source>Expected error: ±%1 (1 σ); cameras that see this point: %2</source>
        <translation>Error esperado: ±%1 (1 σ); cámaras que ven este punto: %2</translation>
    </message>
</context>
<context>
    <name>Method</name>
    <message>
        <source>Any object in the images of one camera (2D)</source>
        <translation>Cualquier objeto en las imágenes de una cámara (2D)</translation>
    </message>
    <message>
        <source>A particle filter with color histograms</source>
        <translation>Un filtro de partículas con histogramas de color</translation>
    </message>
    <message>
        <source>A particle filter with position measurements</source>
        <translation>Un filtro de partículas con medidas de posición</translation>
    </message>
    <message>
        <source>A simple particle filter with color</source>
        <translation>Un filtro de partículas sencillo con color</translation>
    </message>
    <message>
        <source>Colored objects in 3D</source>
        <translation>Objetos de color en 3D</translation>
    </message>
    <message>
        <source>Anything you draw a box around</source>
        <translation>Cualquier cosa que rodee con un recuadro</translation>
    </message>
    <message>
        <source>Balls, hands and other colored objects</source>
        <translation>Pelotas, manos y otros objetos de color</translation>
    </message>
    <message>
        <source>For comparison: mixes up people who come close to each other.</source>
        <translation>Para comparar: confunde entre sí a quienes se acercan.</translation>
    </message>
    <message>
        <source>For comparison: distinguishes people by their clothes.</source>
        <translation>Para comparar: distingue a las personas por su ropa.</translation>
    </message>
    <message>
        <source>For teaching: tracks an object as a box in the images of one camera.</source>
        <translation>Para enseñar: sigue un objeto como recuadro en las imágenes de una cámara.</translation>
    </message>
    <message>
        <source>For teaching: shows how a particle filter works.</source>
        <translation>Para enseñar: muestra cómo funciona un filtro de partículas.</translation>
    </message>
    <message>
        <source>For teaching: shows how particles follow measured positions.</source>
        <translation>Para enseñar: muestra cómo las partículas siguen posiciones medidas.</translation>
    </message>
    <message>
        <source>From papers, for teaching and comparison</source>
        <translation>De artículos, para enseñar y comparar</translation>
    </message>
    <message>
        <source>People by motion alone</source>
        <translation>Personas solo por movimiento</translation>
    </message>
    <message>
        <source>People by motion and color</source>
        <translation>Personas por movimiento y color</translation>
    </message>
    <message>
        <source>People in a room</source>
        <translation>Personas en una sala</translation>
    </message>
    <message>
        <source>People who walk and meet</source>
        <translation>Personas que caminan y se encuentran</translation>
    </message>
    <message>
        <source>Tracks several people on the floor, even in similar clothes.</source>
        <translation>Sigue a varias personas sobre el suelo, aunque lleven ropa parecida.</translation>
    </message>
    <message>
        <source>The most accurate method. It finds out by itself whether the target is a ball or has another shape.</source>
        <translation>El método más preciso. Averigua por sí mismo si el objetivo es una pelota o tiene otra forma.</translation>
    </message>
    <message>
        <source>Tracks an object by its colors, adapts to its size, and finds it again after it was hidden.</source>
        <translation>Sigue un objeto por sus colores, se adapta a su tamaño y lo reencuentra tras una ocultación.</translation>
    </message>
</context>
<context>
    <name>MethodObstacle</name>
    <message>
        <source>Needs calibrated cameras.</source>
        <translation>Necesita cámaras calibradas.</translation>
    </message>
    <message>
        <source>Needs at least two cameras.</source>
        <translation>Necesita al menos dos cámaras.</translation>
    </message>
</context>
<context>
    <name>OutletText</name>
    <message>
        <source>JSON lines at %1</source>
        <translation>Líneas JSON en %1</translation>
    </message>
    <message>
        <source>Web page and WebSocket at %1</source>
        <translation>Página web y WebSocket en %1</translation>
    </message>
    <message>
        <source>OSC messages to %1</source>
        <translation>Mensajes OSC a %1</translation>
    </message>
    <message>
        <source>TUIO cursors to %1</source>
        <translation>Cursores TUIO a %1</translation>
    </message>
    <message>
        <source>CSV lines to the standard output</source>
        <translation>Líneas CSV a la salida estándar</translation>
    </message>
    <message>
        <source>CSV lines to %1</source>
        <translation>Líneas CSV a %1</translation>
    </message>
    <message>
        <source>No program is reading this pipe.</source>
        <translation>Ningún programa lee esta tubería.</translation>
    </message>
    <message>
        <source>Nothing can be written: %1</source>
        <translation>No se puede escribir: %1</translation>
    </message>
</context>
<context>
    <name>PageText</name>
    <message>
        <source>Dewpoint live</source>
        <translation>Dewpoint en vivo</translation>
    </message>
    <message>
        <source>Cameras, targets and their tracks in 3D</source>
        <translation>Cámaras, objetivos y sus trayectorias en 3D</translation>
    </message>
    <message>
        <source>Drag: rotate · Wheel or two fingers: zoom · Double click: reset</source>
        <translation>Arrastrar: girar · Rueda o dos dedos: zoom · Doble clic: restablecer</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Conectando…</translation>
    </message>
    <message>
        <source>Connected. Waiting for images…</source>
        <translation>Conectado. Esperando imágenes…</translation>
    </message>
    <message>
        <source>Not connected. Trying again…</source>
        <translation>Sin conexión. Reintentando…</translation>
    </message>
    <message>
        <source>Frame %1, %2</source>
        <extracomment>%1 is the number of a frame, %2 its time</extracomment>
        <translation>Fotograma %1, %2</translation>
    </message>
    <message>
        <source>tracking</source>
        <translation>seguido</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>ambiguo</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <source>searching</source>
        <translation>buscando</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdido</translation>
    </message>
    <message>
        <source>not present</source>
        <translation>ausente</translation>
    </message>
    <message>
        <source>Only pages from this server can read the results.</source>
        <translation>Solo las páginas de este servidor pueden leer los resultados.</translation>
    </message>
    <message>
        <source>Only GET requests are supported.</source>
        <translation>Solo se admiten peticiones GET.</translation>
    </message>
    <message>
        <source>This server has only one page: /.</source>
        <translation>Este servidor solo tiene una página: /.</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Half the x size of the start box: the particles start evenly spread in this box; 0 starts them all at the same x.</source>
        <translation>Mitad del tamaño en x de la caja inicial: las partículas empiezan repartidas por igual en ella; con 0 todas empiezan en el mismo x.</translation>
    </message>
    <message>
        <source>Half the y size of the start box: the particles start evenly spread in this box; 0 starts them all at the same y.</source>
        <translation>Mitad del tamaño en y de la caja inicial: las partículas empiezan repartidas por igual en ella; con 0 todas empiezan en el mismo y.</translation>
    </message>
    <message>
        <source>Half the z size of the start box: the particles start evenly spread in this box; 0 starts them all at the same z.</source>
        <translation>Mitad del tamaño en z de la caja inicial: las partículas empiezan repartidas por igual en ella; con 0 todas empiezan en el mismo z.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis in one iteration: larger values follow faster objects, but spread the particles wider.</source>
        <translation>Cuánto se mueven al azar las partículas a lo largo de cada eje en una iteración: un valor mayor sigue objetos más rápidos y dispersa más.</translation>
    </message>
    <message>
        <source>How many filter iterations run on each frame.</source>
        <translation>Cuántas iteraciones del filtro se ejecutan en cada fotograma.</translation>
    </message>
    <message>
        <source>Number of particles of the filter: more particles track more reliably, but take more time.</source>
        <translation>Número de partículas del filtro: más partículas siguen con mayor fiabilidad, pero cuestan más tiempo.</translation>
    </message>
    <message>
        <source>Iterations per frame</source>
        <translation>Iteraciones por fotograma</translation>
    </message>
    <message>
        <source>Motion sigma</source>
        <translation>Sigma del movimiento</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partículas</translation>
    </message>
    <message>
        <source>World x coordinate of the center of the box in which the particles start.</source>
        <translation>Coordenada x del mundo del centro de la caja en la que empiezan las partículas.</translation>
    </message>
    <message>
        <source>World y coordinate of the center of the box in which the particles start.</source>
        <translation>Coordenada y del mundo del centro de la caja en la que empiezan las partículas.</translation>
    </message>
    <message>
        <source>World z coordinate of the center of the box in which the particles start.</source>
        <translation>Coordenada z del mundo del centro de la caja en la que empiezan las partículas.</translation>
    </message>
    <message>
        <source>Acceleration sigma</source>
        <translation>Sigma de la aceleración</translation>
    </message>
    <message>
        <source>Edge length of the space in which a target may appear: with larger values, a track is created only at a higher likelihood.</source>
        <translation>Arista del espacio en el que puede aparecer un objetivo: con valores mayores, el seguimiento solo empieza con una verosimilitud más alta.</translation>
    </message>
    <message>
        <source>How long a target still counts as present when no camera can see its expected position.</source>
        <translation>Cuánto tiempo se considera presente un objetivo cuando ninguna cámara puede ver su posición esperada.</translation>
    </message>
    <message>
        <source>Largest number of particles of each target.</source>
        <translation>Número máximo de partículas de cada objetivo.</translation>
    </message>
    <message>
        <source>How strongly targets accelerate, brake and turn: larger values follow abrupt motion, smaller values bridge gaps better.</source>
        <translation>Con cuánta fuerza los objetivos aceleran, frenan y giran: un valor mayor sigue movimientos bruscos, uno menor salva mejor las interrupciones.</translation>
    </message>
    <message>
        <source>Search size</source>
        <translation>Tamaño de búsqueda</translation>
    </message>
    <message>
        <source>Survival time</source>
        <translation>Tiempo de permanencia</translation>
    </message>
    <message>
        <source>Time budget</source>
        <translation>Límite de tiempo</translation>
    </message>
    <message>
        <source>How long one iteration may take. To meet this limit, fewer particles are used and searches are spread over several frames. 0 sets no limit. With a limit, a run depends on the speed of the computer and cannot be repeated exactly.</source>
        <translation>Cuánto puede durar una iteración. Para respetar este límite se usan menos partículas y las búsquedas se reparten entre varios fotogramas. 0 no pone límite. Con un límite, una ejecución depende de la velocidad del equipo y no se puede repetir exactamente.</translation>
    </message>
    <message>
        <source>Color adaptation</source>
        <translation>Adaptación del color</translation>
    </message>
    <message>
        <source>Time constant with which a target&apos;s color range follows slow changes of light, in each camera separately and only while the target is clearly visible. 0 keeps the range as it is; 2 is a good value in a room with daylight.</source>
        <translation>Constante de tiempo con la que el rango de color de un objetivo sigue los cambios lentos de luz, en cada cámara por separado y solo mientras el objetivo se ve con claridad. 0 deja el rango como está; 2 es un buen valor en una sala con luz natural.</translation>
    </message>
    <message>
        <source>Assumed error of a measured position along each axis: larger values trust the particles more, smaller values the measurement.</source>
        <translation>Error supuesto de una posición medida en cada eje: valores mayores confían más en las partículas, menores en la medida.</translation>
    </message>
    <message>
        <source>Observation sigma</source>
        <translation>Sigma de observación</translation>
    </message>
    <message>
        <source>Adaptation</source>
        <translation>Adaptación</translation>
    </message>
    <message>
        <source>Aspect sigma</source>
        <translation>Sigma de la proporción</translation>
    </message>
    <message>
        <source>Min. color share</source>
        <translation>Proporción mín. de color</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis between images, in multiples of the target size, in addition to their constant velocity.</source>
        <translation>Cuánto se mueven al azar las partículas a lo largo de cada eje de una imagen a otra, en múltiplos del tamaño del objetivo, además de su velocidad constante.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis between images, in addition to their constant velocity: larger values follow sudden motion, but spread the particles wider.</source>
        <translation>Cuánto se mueven al azar las partículas a lo largo de cada eje de una imagen a otra, además de su velocidad constante: valores mayores siguen movimientos repentinos, pero las dispersan más.</translation>
    </message>
    <message>
        <source>How strongly positions with more of the target&apos;s colors are preferred.</source>
        <translation>Con qué fuerza se prefieren las posiciones con más colores del objetivo.</translation>
    </message>
    <message>
        <source>Jump reach</source>
        <translation>Alcance de los saltos</translation>
    </message>
    <message>
        <source>Jump share</source>
        <translation>Proporción de saltos</translation>
    </message>
    <message>
        <source>Likelihood sigma</source>
        <translation>Sigma de la verosimilitud</translation>
    </message>
    <message>
        <source>Position sigma</source>
        <translation>Sigma de la posición</translation>
    </message>
    <message>
        <source>Scale sigma</source>
        <translation>Sigma de la escala</translation>
    </message>
    <message>
        <source>How much of the box&apos;s current colors is blended into the reference colors after each image; 0 keeps the colors of the first image.</source>
        <translation>Cuánto de los colores actuales del recuadro se mezcla en los de referencia en cada imagen; 0 conserva los colores de la primera imagen.</translation>
    </message>
    <message>
        <source>Share of the particles that jump to other positions at which the target&apos;s colors are found.</source>
        <translation>Proporción de partículas que saltan a otras posiciones en las que se encuentran los colores del objetivo.</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Nitidez</translation>
    </message>
    <message>
        <source>The target counts as hidden and keeps its position if less than this share of its usual colors is found.</source>
        <translation>El objetivo se considera oculto y conserva su posición si se encuentra menos de esta proporción de sus colores habituales.</translation>
    </message>
    <message>
        <source>Time after which a new object that stays in place counts as background.</source>
        <translation>Tiempo tras el cual un objeto nuevo que no se mueve cuenta como fondo.</translation>
    </message>
    <message>
        <source>Half width of the area, x</source>
        <translation>Zona: semitamaño x</translation>
    </message>
    <message>
        <source>Half width of the area, y</source>
        <translation>Zona: semitamaño y</translation>
    </message>
    <message>
        <source>Area x</source>
        <translation>Zona x</translation>
    </message>
    <message>
        <source>Area y</source>
        <translation>Zona y</translation>
    </message>
    <message>
        <source>Background memory</source>
        <translation>Memoria del fondo</translation>
    </message>
    <message>
        <source>Background model</source>
        <translation>Modelo de fondo</translation>
    </message>
    <message>
        <source>Confirmation time</source>
        <translation>Tiempo de confirmación</translation>
    </message>
    <message>
        <source>Create tracks</source>
        <translation>Apariciones</translation>
    </message>
    <message>
        <source>Body points</source>
        <translation>Puntos del cuerpo</translation>
    </message>
    <message>
        <source>Color noise</source>
        <translation>Ruido de color</translation>
    </message>
    <message>
        <source>Color weight</source>
        <translation>Peso del color</translation>
    </message>
    <message>
        <source>Darkest shadow</source>
        <translation>Sombra más oscura</translation>
    </message>
    <message>
        <source>Weight per camera</source>
        <translation>Peso por cámara</translation>
    </message>
    <message>
        <source>Floor z</source>
        <translation>Suelo z</translation>
    </message>
    <message>
        <source>Assumed height of a person whose height is not known yet.</source>
        <translation>Estatura supuesta de una persona cuya estatura aún no se conoce.</translation>
    </message>
    <message>
        <source>Height of the floor in world coordinates.</source>
        <translation>Altura del suelo en coordenadas del mundo.</translation>
    </message>
    <message>
        <source>How long a person still counts as present when fewer than two cameras see the person.</source>
        <translation>Cuánto tiempo se considera presente a una persona cuando la ven menos de dos cámaras.</translation>
    </message>
    <message>
        <source>Number of particles of each person.</source>
        <translation>Número de partículas de cada persona.</translation>
    </message>
    <message>
        <source>Number of points that represent the volume of each person.</source>
        <translation>Número de puntos que representan el volumen de cada persona.</translation>
    </message>
    <message>
        <source>How much the colors of clothes count compared with the masks when people are close to each other.</source>
        <translation>Cuánto cuentan los colores de la ropa en comparación con las máscaras cuando las personas están cerca.</translation>
    </message>
    <message>
        <source>Smallest distance between the centers of two people.</source>
        <translation>Distancia mínima entre los centros de dos personas.</translation>
    </message>
    <message>
        <source>How strongly people accelerate, brake and turn.</source>
        <translation>Con cuánta fuerza las personas aceleran, frenan y giran.</translation>
    </message>
    <message>
        <source>Min. hue likelihood</source>
        <translation>Verosimilitud mínima del tono</translation>
    </message>
    <message>
        <source>Hue sigma</source>
        <translation>Sigma del tono</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>Ancho de imagen</translation>
    </message>
    <message>
        <source>Images are reduced to at most this width before they are analyzed; 0 keeps them as they are.</source>
        <translation>Las imágenes se reducen como mucho a este ancho antes de analizarlas; 0 las deja como están.</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>Tiempo de aprendizaje</translation>
    </message>
    <message>
        <source>Minimum distance</source>
        <translation>Distancia mínima</translation>
    </message>
    <message>
        <source>Lower limit of the likelihood of a pixel&apos;s hue (h_B in the paper); above 0 because another object may hide the person.</source>
        <translation>Límite inferior de la verosimilitud del tono de un píxel (h_B del artículo); mayor que 0 porque otro objeto puede tapar a la persona.</translation>
    </message>
    <message>
        <source>Lower limit of the likelihood of a pixel&apos;s saturation (s_B in the paper).</source>
        <translation>Límite inferior de la verosimilitud de la saturación de un píxel (s_B del artículo).</translation>
    </message>
    <message>
        <source>Smallest likelihood where a camera sees no motion (p_B in the paper: 0.2).</source>
        <translation>Verosimilitud mínima donde una cámara no ve movimiento (p_B del artículo: 0,2).</translation>
    </message>
    <message>
        <source>Mask smoothing</source>
        <translation>Suavizado de la máscara</translation>
    </message>
    <message>
        <source>Min. motion likelihood</source>
        <translation>Verosimilitud mínima de movimiento</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>Ruido de posición</translation>
    </message>
    <message>
        <source>Min. saturation likelihood</source>
        <translation>Verosimilitud mínima de la saturación</translation>
    </message>
    <message>
        <source>Saturation sigma</source>
        <translation>Sigma de la saturación</translation>
    </message>
    <message>
        <source>Sigma of the Gaussian that smooths the motion masks (the paper: 4 px).</source>
        <translation>Sigma de la gaussiana que suaviza las máscaras de movimiento (en el artículo: 4 px).</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each component of the velocity, per frame.</source>
        <translation>Desviación típica del ruido en cada componente de la velocidad, por fotograma.</translation>
    </message>
    <message>
        <source>Standard deviation of the random motion that is added to each coordinate of a particle, per frame.</source>
        <translation>Desviación típica del movimiento aleatorio que se añade a cada coordenada de una partícula, por fotograma.</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on hue and saturation, per frame.</source>
        <translation>Desviación típica del ruido en tono y saturación, por fotograma.</translation>
    </message>
    <message>
        <source>Usual height</source>
        <translation>Estatura habitual</translation>
    </message>
    <message>
        <source>Velocity noise</source>
        <translation>Ruido de velocidad</translation>
    </message>
    <message>
        <source>Calibration error</source>
        <translation>Error de calibración</translation>
    </message>
    <message>
        <source>Error of the directions in which the cameras see objects. It is part of the reported uncertainty of a position. 0.25 suits a calibration by hand.</source>
        <translation>Error de las direcciones en las que las cámaras ven los objetos. Forma parte de la incertidumbre indicada de una posición. 0,25 es adecuado para una calibración a mano.</translation>
    </message>
    <message>
        <source>Time error</source>
        <translation>Error de tiempo</translation>
    </message>
    <message>
        <source>1 tracks every person that several cameras see. 0 tracks only people that you add by hand.</source>
        <translation>1 sigue a toda persona que ven varias cámaras. 0 sigue solo a las personas que usted añade a mano.</translation>
    </message>
    <message>
        <source>Coordinate of the center of the tracked floor area along this axis.</source>
        <translation>Coordenada del centro de la superficie de suelo seguida a lo largo de este eje.</translation>
    </message>
    <message>
        <source>Error of the times at which the images were taken. It is part of the reported uncertainty of a moving target. 8 suits webcams.</source>
        <translation>Error de los tiempos en que se tomaron las imágenes. Forma parte de la incertidumbre indicada de un objetivo en movimiento. 8 es adecuado para cámaras web.</translation>
    </message>
    <message>
        <source>Half the size of the tracked floor area along this axis. A person who crosses the border of the area counts as having left.</source>
        <translation>Mitad del tamaño del suelo vigilado en este eje. Una persona que cruza el borde de esta zona cuenta como que se ha ido.</translation>
    </message>
    <message>
        <source>How far the particles may deviate from the distribution that they represent (Kullback-Leibler divergence). A smaller value uses more particles when the cloud is spread out; 0 always uses the largest number.</source>
        <translation>Cuánto pueden apartarse las partículas de la distribución que representan (divergencia de Kullback-Leibler). Un valor menor usa más partículas cuando la nube está dispersa; 0 usa siempre el número máximo.</translation>
    </message>
    <message>
        <source>How far the target may be from its predicted position, in multiples of the target size. Positions that are farther away count as unlikely.</source>
        <translation>Cuánto puede alejarse el objetivo de su posición prevista, en múltiplos del tamaño del objetivo. Las posiciones más lejanas se consideran improbables.</translation>
    </message>
    <message>
        <source>How long a moving region that belongs to no tracked person must be visible before a new track is created.</source>
        <translation>Cuánto tiempo debe verse una zona en movimiento que no corresponde a ninguna persona seguida antes de iniciar un seguimiento nuevo.</translation>
    </message>
    <message>
        <source>How long the cameras only learn the background at the start. Nobody should be in view during this time.</source>
        <translation>Cuánto tiempo aprenden las cámaras solo el fondo al principio. Durante este tiempo no debe haber nadie a la vista.</translation>
    </message>
    <message>
        <source>How moving regions are found. 0: one Gaussian for each pixel (fast). 1: MOG2 of OpenCV. 2: KNN of OpenCV.</source>
        <translation>Cómo se hallan las zonas en movimiento. 0: una gaussiana por píxel (rápido). 1: MOG2 de OpenCV. 2: KNN de OpenCV.</translation>
    </message>
    <message>
        <source>How strongly the mask of each camera influences where a person is tracked: larger values rely more on the masks.</source>
        <translation>Con qué fuerza influye la máscara de cada cámara en la posición de una persona: valores mayores confían más en las máscaras.</translation>
    </message>
    <message>
        <source>How much the colors of a particle&apos;s box may differ from the reference colors (Bhattacharyya distance): smaller values trust the best particles more.</source>
        <translation>Cuánto pueden diferir los colores del recuadro de una partícula de los colores de referencia (distancia de Bhattacharyya): un valor menor confía más en las mejores partículas.</translation>
    </message>
    <message>
        <source>How much the ratio of width to height may change between images, as the standard deviation of its logarithm; 0 keeps the initial ratio.</source>
        <translation>Cuánto puede cambiar la proporción entre anchura y altura de una imagen a otra, como desviación típica de su logaritmo; 0 conserva la proporción inicial.</translation>
    </message>
    <message>
        <source>How much the size of the box may change between images, as the standard deviation of its logarithm; 0 keeps the initial size.</source>
        <translation>Cuánto puede cambiar el tamaño del recuadro de una imagen a otra, como desviación típica de su logaritmo; 0 conserva el tamaño inicial.</translation>
    </message>
    <message>
        <source>Lowest brightness of a shadow, as a share of the background&apos;s brightness at the same hue. Anything darker counts as a moving region.</source>
        <translation>Brillo mínimo de una sombra, como proporción del brillo del fondo con el mismo tono. Todo lo más oscuro cuenta como zona en movimiento.</translation>
    </message>
    <message>
        <source>Smallest number of particles of each target; used when all its particles are close together.</source>
        <translation>Número mínimo de partículas de cada objetivo, que se usa cuando todas están muy juntas.</translation>
    </message>
    <message>
        <source>Standard deviation of a measured hue; hues range from 0 to 1.</source>
        <translation>Desviación típica de un tono medido; los tonos van de 0 a 1.</translation>
    </message>
    <message>
        <source>Standard deviation of a measured saturation; saturations range from 0 to 1.</source>
        <translation>Desviación típica de una saturación medida; las saturaciones van de 0 a 1.</translation>
    </message>
    <message>
        <source>Delay spread</source>
        <translation>Dispersión de los retardos</translation>
    </message>
    <message>
        <source>How much the delays of the cameras may differ (standard deviation). While a target moves, the delays are estimated and corrected. 0 if all time stamps are exact: then no delay is estimated.</source>
        <translation>Cuánto pueden diferir los retardos de las cámaras (desviación típica). Mientras un objetivo se mueve, los retardos se estiman y se corrigen. 0 si todas las marcas de tiempo son exactas: entonces no se estima ningún retardo.</translation>
    </message>
    <message>
        <source>KLD error</source>
        <translation>Error KLD</translation>
    </message>
    <message>
        <source>Minimum particles</source>
        <translation>Mínimo de partículas</translation>
    </message>
    <message>
        <source>Start box, center x</source>
        <translation>Caja inicial, centro x</translation>
    </message>
    <message>
        <source>Start box, center y</source>
        <translation>Caja inicial, centro y</translation>
    </message>
    <message>
        <source>Start box, center z</source>
        <translation>Caja inicial, centro z</translation>
    </message>
    <message>
        <source>Start box, half width x</source>
        <translation>Caja inicial, semiancho x</translation>
    </message>
    <message>
        <source>Start box, half width y</source>
        <translation>Caja inicial, semiancho y</translation>
    </message>
    <message>
        <source>Start box, half width z</source>
        <translation>Caja inicial, semiancho z</translation>
    </message>
</context>
<context>
    <name>ParameterGroup</name>
    <message>
        <source>Area and people</source>
        <translation>Zona y personas</translation>
    </message>
    <message>
        <source>Essential</source>
        <translation>Esencial</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Avanzado</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Medición</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Search and start</source>
        <translation>Búsqueda e inicio</translation>
    </message>
</context>
<context>
    <name>ParameterRow</name>
    <message>
        <source>%1
From %2 to %3%4; default %5%4.</source>
        <translation>%1
De %2 a %3%4; por defecto %5%4.</translation>
    </message>
    <message>
        <source>%1
From %2 to %3%4; the default comes from the region that the cameras see.</source>
        <translation>%1
De %2 a %3%4; el valor por defecto sale de la región que ven las cámaras.</translation>
    </message>
    <message>
        <source>Changed: the default is %1.</source>
        <translation>Cambiado: el valor por defecto es %1.</translation>
    </message>
    <message>
        <source>Reset to %1 (Backspace on the slider)</source>
        <translation>Restablecer a %1 (Retroceso en el deslizador)</translation>
    </message>
</context>
<context>
    <name>People</name>
    <message>
        <source>learning background: %1 % · keep the scene empty</source>
        <translation>aprendiendo el fondo: %1 % · no entre en la imagen</translation>
    </message>
    <message>
        <source>image ignored: %1 % of it is moving</source>
        <translation>imagen ignorada: se mueve el %1 %</translation>
    </message>
    <message>
        <source>learning: %1 %</source>
        <translation>aprendiendo: %1 %</translation>
    </message>
</context>
<context>
    <name>PlotAxisStrip</name>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>iteración</translation>
    </message>
</context>
<context>
    <name>PlotFigure</name>
    <message>
        <source>time, s</source>
        <translation>tiempo, s</translation>
    </message>
    <message>
        <source>filter iteration</source>
        <translation>iteración del filtro</translation>
    </message>
    <message>
        <source>Dewpoint plots</source>
        <translation>Gráficos de Dewpoint</translation>
    </message>
</context>
<context>
    <name>PlotQuantity</name>
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
        <translation>verdad</translation>
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
    <message>
        <source>%1 fps</source>
        <translation>%1 fotogramas/s</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>no image</source>
        <translation>sin imagen</translation>
    </message>
    <message>
        <source>camera covered or moved</source>
        <translation>cámara tapada o movida</translation>
    </message>
    <message>
        <source>too dark</source>
        <translation>demasiado oscuro</translation>
    </message>
    <message>
        <source>out of view</source>
        <translation>fuera de la vista</translation>
    </message>
    <message>
        <source>partly hidden</source>
        <translation>parcialmente oculto</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <source>at a distractor</source>
        <translation>en un distractor</translation>
    </message>
    <message>
        <source>%1 away from a distractor</source>
        <translation>a %1 de un distractor</translation>
    </message>
    <message>
        <source>no matching color</source>
        <translation>sin color que coincida</translation>
    </message>
    <message>
        <source>color found %1 away</source>
        <translation>color hallado a %1</translation>
    </message>
    <message>
        <source>right color, wrong shape</source>
        <translation>color correcto, forma incorrecta</translation>
    </message>
    <message>
        <source>hidden here</source>
        <translation>oculto aquí</translation>
    </message>
    <message>
        <source>not in this image</source>
        <translation>no está en esta imagen</translation>
    </message>
</context>
<context>
    <name>RunPlots</name>
    <message>
        <source>all cameras</source>
        <translation>todas las cámaras</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Dispersión</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>Tamaño efectivo de la muestra</translation>
    </message>
    <message>
        <source>effective</source>
        <translation>efectivo</translation>
    </message>
    <message>
        <source>particles</source>
        <translation>partículas</translation>
    </message>
    <message>
        <source>Log likelihood</source>
        <translation>Log-verosimilitud</translation>
    </message>
    <message>
        <source>Existence</source>
        <translation>Existencia</translation>
    </message>
    <message>
        <source>Error against ground truth</source>
        <translation>Error respecto a la posición verdadera</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>Time per step</source>
        <translation>Tiempo por paso</translation>
    </message>
    <message>
        <source>one iteration</source>
        <translation>una iteración</translation>
    </message>
    <message>
        <source>Similarity</source>
        <translation>Similitud</translation>
    </message>
    <message>
        <source>similarity to the reference colors</source>
        <translation>similitud con los colores de referencia</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>width</source>
        <translation>anchura</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altura</translation>
    </message>
</context>
<context>
    <name>SizeFitText</name>
    <message>
        <source>same as during calibration</source>
        <translation>iguales que en la calibración</translation>
    </message>
    <message>
        <source>cropped on all sides</source>
        <translation>recortadas por todos los lados</translation>
    </message>
    <message>
        <source>cropped at the right and at the bottom</source>
        <translation>recortadas a la derecha y abajo</translation>
    </message>
    <message>
        <source>scaled</source>
        <translation>escaladas</translation>
    </message>
    <message>
        <source>rotated clockwise by 90°</source>
        <translation>giradas 90° en sentido horario</translation>
    </message>
    <message>
        <source>rotated clockwise by 270°</source>
        <translation>giradas 270° en sentido horario</translation>
    </message>
</context>
<context>
    <name>TakeText</name>
    <message>
        <source>%1 left</source>
        <translation>quedan %1</translation>
    </message>
    <message>
        <source>Recording take %1</source>
        <translation>Grabando la toma %1</translation>
    </message>
    <message numerus="yes">
        <source>%n dropped image(s)</source>
        <translation>
            <numerusform>%n imagen perdida</numerusform>
            <numerusform>%n imágenes perdidas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>%1 libres</translation>
    </message>
    <message>
        <source>%1: %2 images, %3, %4 dropped, %5</source>
        <translation>%1: %2 imágenes, %3, %4 perdidas, %5</translation>
    </message>
    <message>
        <source>The take contains %1 from before you pressed Record. There was not enough memory for more.</source>
        <translation>La toma contiene %1 anteriores al inicio; no había memoria para más.</translation>
    </message>
    <message>
        <source>The take contains %1 from before you pressed Record.</source>
        <translation>La toma contiene %1 anteriores al inicio.</translation>
    </message>
    <message>
        <source>The run began before the take, so the run cannot be tracked again from its beginning. To avoid this, restart the run while you record.</source>
        <translation>La ejecución empezó antes de la toma, así que no se puede repetir desde su principio. Para evitarlo, reinicie la ejecución mientras graba.</translation>
    </message>
    <message>
        <source>Tracking the take gives exactly the results of the live run in all %1 frames.</source>
        <translation>Al seguir la toma se obtienen exactamente los resultados de la ejecución en vivo en los %1 fotogramas.</translation>
    </message>
    <message>
        <source>%1 of %2 frames differ from the live run, the first one is frame %3. Positions differ by up to %4.</source>
        <translation>%1 de %2 fotogramas difieren de la ejecución en vivo; el primero es el fotograma %3. Las posiciones difieren hasta en %4.</translation>
    </message>
    <message>
        <source>Images of %1 frames were dropped, the first in frame %2.</source>
        <translation>Se perdieron imágenes de %1 fotogramas, la primera en el fotograma %2.</translation>
    </message>
    <message>
        <source>Frames %1 to %2 were tracked with other settings.</source>
        <translation>Los fotogramas %1 a %2 se siguieron con otros ajustes.</translation>
    </message>
    <message>
        <source>A time budget is set, so results depend on the speed of the computer.</source>
        <translation>Hay un límite de tiempo fijado, así que los resultados dependen de la velocidad del ordenador.</translation>
    </message>
    <message>
        <source>The images of %1 are stored with slightly different colors, because the camera sends them uncompressed.</source>
        <translation>Las imágenes de %1 se guardan con colores ligeramente distintos, porque la cámara las envía sin comprimir.</translation>
    </message>
</context>
<context>
    <name>TargetPanel</name>
    <message>
        <source>%1, in %2
Center %3, %4, size %5 × %6
Similarity %7
Effective sample size %8 of %9</source>
        <translation>%1, en %2
Centro %3, %4, tamaño %5 × %6
Similitud %7
Tamaño efectivo de la muestra %8 de %9</translation>
    </message>
    <message>
        <source>Spread %1</source>
        <translation>Dispersión %1</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Frame %1, %2</source>
        <translation>Fotograma %1, %2</translation>
    </message>
    <message>
        <source>not tracked</source>
        <translation>sin seguimiento</translation>
    </message>
    <message>
        <source>✕ %1</source>
        <translation>✕ %1</translation>
    </message>
    <message>
        <source>tracking frames %2 to %3 again: now at %1</source>
        <translation>siguiendo de nuevo los fotogramas %2 a %3: ahora en %1</translation>
    </message>
    <message>
        <source>✕ no image</source>
        <translation>✕ sin imagen</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>corregido</translation>
    </message>
    <message>
        <source>tracked with earlier settings</source>
        <translation>seguido con ajustes anteriores</translation>
    </message>
    <message>
        <source>The state of each target appears here during tracking.</source>
        <translation>El estado de cada objetivo aparece aquí durante el seguimiento.</translation>
    </message>
</context>
<context>
    <name>TrackingState</name>
    <message>
        <source>○ searching</source>
        <translation>○ buscando</translation>
    </message>
    <message>
        <source>▲ lost</source>
        <translation>▲ perdido</translation>
    </message>
    <message>
        <source>✕ missing</source>
        <translation>✕ ausente</translation>
    </message>
    <message>
        <source>– no images</source>
        <translation>– sin imágenes</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>Aún sin objetivo</translation>
    </message>
    <message>
        <source>– not tracked</source>
        <translation>– sin seguir</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ oculto</translation>
    </message>
    <message>
        <source>– no box</source>
        <translation>– sin recuadro</translation>
    </message>
    <message>
        <source>◔ learning background</source>
        <translation>◔ aprende el fondo</translation>
    </message>
    <message>
        <source>◌ nobody in view</source>
        <translation>◌ nadie a la vista</translation>
    </message>
    <message>
        <source>– not present</source>
        <translation>– ausente</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ ambiguo</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● seguido</translation>
    </message>
</context>
<context>
    <name>TransportBar</name>
    <message>
        <source>Toolbar</source>
        <translation>Barra de herramientas</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
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
        <translation>tamaños</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
</context>
<context>
    <name>VideoDialog</name>
    <message>
        <source>Frame %1</source>
        <translation>Fotograma %1</translation>
    </message>
</context>
<context>
    <name>WandSettings</name>
    <message>
        <source>The ball touches the floor</source>
        <translation>La pelota toca el suelo</translation>
    </message>
    <message>
        <source>The ball is at one end of the known distance</source>
        <translation>La pelota está en un extremo de la distancia conocida</translation>
    </message>
    <message>
        <source>The ball is at the other end of the known distance</source>
        <translation>La pelota está en el otro extremo de la distancia conocida</translation>
    </message>
    <message>
        <source>First frame of the fall</source>
        <translation>Primer fotograma de la caída</translation>
    </message>
    <message>
        <source>Last frame of the fall</source>
        <translation>Último fotograma de la caída</translation>
    </message>
    <message>
        <source>At least two cameras must see the ball.</source>
        <translation>Dos o más cámaras deben ver la pelota.</translation>
    </message>
    <message>
        <source>The scale comes from a known distance: add the times at which the ball is at each end of this distance.</source>
        <translation>La escala se toma de una distancia conocida: añada los instantes en que la pelota está en cada extremo de esa distancia.</translation>
    </message>
    <message>
        <source>To use a fall, add two times: the first and the last frame of the fall.</source>
        <translation>Para usar una caída, añada dos instantes: el primer y el último fotograma de la caída.</translation>
    </message>
    <message>
        <source>Both ends of the wand are the same target: choose another target for one of them.</source>
        <translation>Los dos extremos de la varita son el mismo objetivo: elija otro objetivo para uno de ellos.</translation>
    </message>
    <message>
        <source>Learn the color of the ball first: press “Learn the color” in the toolbar, then click the ball in an image.</source>
        <translation>Aprenda primero el color de la pelota: pulse «Aprender el color» en la barra de herramientas y haga clic en la pelota en una imagen.</translation>
    </message>
    <message>
        <source>A wand has two balls of different colors: press “Add a target” in the toolbar, then click the second ball in an image.</source>
        <translation>Una varita tiene dos pelotas de colores distintos: pulse «Añadir un objetivo» en la barra de herramientas y haga clic en la segunda pelota en una imagen.</translation>
    </message>
    <message>
        <source>Also move the ball to the left part of the image of %1.</source>
        <translation>Mueva la bola también a la parte izquierda de la imagen de %1.</translation>
    </message>
    <message>
        <source>Also move the ball to the right part of the image of %1.</source>
        <translation>Mueva la bola también a la parte derecha de la imagen de %1.</translation>
    </message>
    <message>
        <source>Also move the ball to the upper part of the image of %1.</source>
        <translation>Mueva la bola también a la parte superior de la imagen de %1.</translation>
    </message>
    <message>
        <source>Also move the ball to the lower part of the image of %1.</source>
        <translation>Mueva la bola también a la parte inferior de la imagen de %1.</translation>
    </message>
    <message>
        <source>Also move the ball to all edges of the image of %1.</source>
        <translation>Mueva la bola también a todos los bordes de la imagen de %1.</translation>
    </message>
    <message>
        <source>The ball was seen for only %1. Wave for half a minute.</source>
        <translation>La bola se vio solo durante %1. Muévala durante medio minuto.</translation>
    </message>
    <message>
        <source>The ball moved only along one line. Move it in all directions: to the sides, up and down, near and far.</source>
        <translation>La bola se movió solo a lo largo de una línea. Muévala en todas las direcciones: a los lados, arriba y abajo, cerca y lejos.</translation>
    </message>
    <message>
        <source>The ball moved only within a plane (%1 thick). Also move it across this plane: toward %2 and away from it.</source>
        <translation>La bola se movió solo dentro de un plano (%1 de grosor). Muévala también a través de este plano: hacia %2 y alejándola.</translation>
    </message>
    <message>
        <source>The distance from %1 to the ball hardly changed (by only %2). Also move the ball toward %1 and away from it.</source>
        <translation>La distancia de %1 a la bola apenas cambió (solo %2). Acerque también la bola a %1 y aléjela.</translation>
    </message>
    <message>
        <source>The ball stayed in %1 of the volume that the cameras see together. Move it through the whole volume in which you will track.</source>
        <translation>La bola se quedó en el %1 del volumen que las cámaras ven en común. Muévala por todo el volumen en el que vaya a hacer el seguimiento.</translation>
    </message>
    <message>
        <source>%1 saw the ball in only %2 of its image.</source>
        <translation>%1 vio la bola solo en el %2 de su imagen.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %2 saw the ball at the same time in only %n frame(s). Move the ball where both cameras see it.</source>
        <translation>
            <numerusform>%1 y %2 vieron la bola a la vez en solo %n fotograma. Muévala donde ambas cámaras la vean.</numerusform>
            <numerusform>%1 y %2 vieron la bola a la vez en solo %n fotogramas. Muévala donde ambas cámaras la vean.</numerusform>
        </translation>
    </message>
    <message>
        <source>The cameras were calibrated before, and the motion in this recording is not enough to improve that calibration. Keep the previous calibration.</source>
        <translation>Las cámaras ya estaban calibradas, y el movimiento de esta grabación no basta para mejorar esa calibración. Conserve la calibración anterior.</translation>
    </message>
    <message>
        <source>The old camera positions are known more accurately (±%1) than the new ones (±%2). Keep the old positions.</source>
        <translation>Las posiciones anteriores de las cámaras se conocen con más exactitud (±%1) que las nuevas (±%2). Conserve las posiciones anteriores.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AboutDialog</name>
    <message>
        <source>Show license</source>
        <translation>Mostrar la licencia</translation>
    </message>
    <message>
        <source>Hide license</source>
        <translation>Ocultar la licencia</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Acerca de Dewpoint</translation>
    </message>
    <message>
        <source>Dewpoint %1</source>
        <translation>Dewpoint %1</translation>
    </message>
    <message>
        <source>Tracks colored objects in 3D, live, from ordinary cameras with particle filters.</source>
        <translation>Sigue objetos de color en 3D, en vivo, desde cámaras corrientes con filtros de partículas.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later (GPL-3.0-or-later), without any warranty.</source>
        <translation>Software libre bajo la GNU General Public License, versión 3 o posterior (GPL-3.0-or-later), sin garantía alguna.</translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation>Cómo citar</translation>
    </message>
    <message>
        <source>Show or hide the full text of the license</source>
        <translation>Mostrar el texto completo de la licencia u ocultarlo</translation>
    </message>
    <message>
        <source>Copy citation</source>
        <translation>Copiar la cita</translation>
    </message>
    <message>
        <source>Copy the entry for your reference list</source>
        <translation>Copiar la entrada para su lista de referencias</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddPersonTool</name>
    <message>
        <source>Click the person</source>
        <translation>Haga clic en la persona</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter adds a person there</source>
        <translation>Imagen de %1: las flechas mueven una cruz, Intro añade allí una persona</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddressForm</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Probar</translation>
    </message>
    <message>
        <source>Add a camera with this address to the project</source>
        <translation>Añadir al proyecto una cámara con esta dirección</translation>
    </message>
    <message>
        <source>Make this address the image source of the selected camera</source>
        <translation>Usar esta dirección como fuente de imágenes de la cámara seleccionada</translation>
    </message>
    <message>
        <source>Waiting for the first image…</source>
        <translation>Esperando la primera imagen…</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>✓ %1</source>
        <translation>✓ %1</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>RTSP camera</source>
        <translation>Cámara RTSP</translation>
    </message>
    <message>
        <source>MJPEG over HTTP</source>
        <translation>MJPEG por HTTP</translation>
    </message>
    <message>
        <source>RTP over UDP</source>
        <translation>RTP por UDP</translation>
    </message>
    <message>
        <source>SRT</source>
        <translation>SRT</translation>
    </message>
    <message>
        <source>GStreamer pipeline</source>
        <translation>Pipeline de GStreamer</translation>
    </message>
    <message>
        <source>Test pattern</source>
        <translation>Carta de ajuste</translation>
    </message>
    <message>
        <source>Kind of address</source>
        <translation>Tipo de dirección</translation>
    </message>
    <message>
        <source>Shows what an address of this kind looks like</source>
        <translation>Muestra cómo es una dirección de este tipo</translation>
    </message>
    <message>
        <source>Address of the camera</source>
        <translation>Dirección de la cámara</translation>
    </message>
    <message>
        <source>Address of a network camera, a GStreamer pipeline or a test pattern</source>
        <translation>Dirección de una cámara de red, una pipeline de GStreamer o una carta de ajuste</translation>
    </message>
    <message>
        <source>Open the address, and show the first image, its size and the frame rate</source>
        <translation>Abrir la dirección y mostrar la primera imagen, su tamaño y la frecuencia de imágenes</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Assign to selected camera</source>
        <translation>Asignar a la cámara seleccionada</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackgroundImageTaker</name>
    <message>
        <source>“%1” is visible in this image and would become part of the background. Choose a frame without this target.</source>
        <translation>«%1» se ve en esta imagen y pasaría a formar parte del fondo. Elija un fotograma sin este objetivo.</translation>
    </message>
    <message>
        <source>Use image anyway</source>
        <translation>Usar la imagen de todos modos</translation>
    </message>
    <message>
        <source>The image was saved as %1, but is not used, because the settings of the camera were changed in the meantime.</source>
        <translation>La imagen se guardó como %1, pero no se usa, porque los ajustes de la cámara cambiaron mientras tanto.</translation>
    </message>
    <message>
        <source>Change background image</source>
        <translation>Cambiar la imagen de fondo</translation>
    </message>
    <message>
        <source>The current image is now the background image of %1. It was saved as %2.</source>
        <translation>La imagen actual es ahora la imagen de fondo de %1. Se guardó como %2.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackwardTracker</name>
    <message>
        <source>Correct position</source>
        <translation>Corregir la posición</translation>
    </message>
    <message>
        <source>The target was tracked backward to frame %1. It is now being tracked forward again from this frame.</source>
        <translation>El objetivo se siguió hacia atrás hasta el fotograma %1. Desde ese fotograma se sigue ahora de nuevo hacia delante.</translation>
    </message>
    <message>
        <source>Tracking the target backward: frame %1.</source>
        <translation>Siguiendo el objetivo hacia atrás: fotograma %1.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BirdsEyeView</name>
    <message>
        <source>Bird&apos;s-eye view</source>
        <translation>Vista de pájaro</translation>
    </message>
    <message>
        <source>The room in 3D: cameras, particles, estimates and their tracks</source>
        <translation>La sala en 3D: cámaras, partículas, estimaciones y sus trayectorias</translation>
    </message>
    <message>
        <source>3D view not available: %1</source>
        <translation>Vista 3D no disponible: %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrationPage</name>
    <message>
        <source>Board</source>
        <translation>Tablero</translation>
    </message>
    <message>
        <source>Values to calibrate</source>
        <translation>Valores que se calibran</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Calibrar</translation>
    </message>
    <message>
        <source>Find the board in the recording and calibrate the cameras with it (one undo step)</source>
        <translation>Buscar el tablero en la grabación y calibrar con él las cámaras (se deshace en un paso)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop and keep the previous calibration</source>
        <translation>Detener y conservar la calibración anterior</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Use the calibration in the project (one undo step)</source>
        <translation>Usar la calibración en el proyecto (se deshace en un paso)</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>Save a page with the residuals, coverage and errors of all images, and open it</source>
        <translation>Guardar y abrir una página con residuos, cobertura y errores de todas las imágenes</translation>
    </message>
    <message>
        <source>Calibration progress</source>
        <translation>Avance de la calibración</translation>
    </message>
    <message>
        <source>Show a printed board to the cameras. This page says what to show next. A view is captured when you hold the board still.</source>
        <translation>Muestre un tablero impreso a las cámaras. Esta página indica qué mostrar después. Se captura una vista cuando mantiene quieto el tablero.</translation>
    </message>
    <message>
        <source>To calibrate from a recording, record a printed board that you hold still in many positions, some of them close to the camera or tilted.</source>
        <translation>Para calibrar con una grabación, grabe un tablero impreso que mantiene quieto en muchas posiciones, en algunas cerca de la cámara o inclinado.</translation>
    </message>
    <message>
        <source>Live cameras</source>
        <translation>Cámaras en vivo</translation>
    </message>
    <message>
        <source>This recording</source>
        <translation>Esta grabación</translation>
    </message>
    <message>
        <source>✓ The cameras are calibrated (Ctrl+Z undoes this).</source>
        <translation>✓ Las cámaras están calibradas (Ctrl+Z lo deshace).</translation>
    </message>
    <message>
        <source>Looking for the board: %p %</source>
        <translation>Buscando el tablero: %p %</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>Página (*.html)</translation>
    </message>
    <message>
        <source>Use calibration anyway</source>
        <translation>Usar la calibración de todos modos</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
    <message>
        <source>Find board</source>
        <translation>Buscar tablero</translation>
    </message>
    <message>
        <source>Use this board</source>
        <translation>Usar este tablero</translation>
    </message>
    <message>
        <source>Search all frames</source>
        <translation>Buscar en todos los fotogramas</translation>
    </message>
    <message>
        <source>Find out from the images which kind of board they show, how many squares it has, and its dictionary. The images do not show how large the squares are: measure this yourself</source>
        <translation>Averiguar con las imágenes qué tipo de tablero muestran, cuántas casillas tiene y su diccionario. Las imágenes no muestran el tamaño de las casillas: mídalo usted</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Calculando</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show the board that you described.</source>
        <translation>%1 de las %2 imágenes examinadas muestran el tablero que usted describió.</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Reflejar imágenes</translation>
    </message>
    <message>
        <source>Saved %1: the board is larger than the paper. Page 1 shows how to put its %2 sheets together.</source>
        <translation>Se guardó %1: el tablero es más grande que el papel. La página 1 muestra cómo unir las %2 hojas.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrator</name>
    <message>
        <source>Stopped. The previous calibration is kept.</source>
        <translation>Detenido. Se conserva la calibración anterior.</translation>
    </message>
    <message>
        <source>The cameras of the project have changed: calibrate again.</source>
        <translation>Las cámaras del proyecto han cambiado: calibre de nuevo.</translation>
    </message>
    <message>
        <source>Calibrate with a board</source>
        <translation>Calibrar con un tablero</translation>
    </message>
    <message>
        <source>No board was found. Show the whole board in focus and in even light, then press Find board again.</source>
        <translation>No se encontró ningún tablero. Muestre el tablero entero, enfocado y con luz uniforme, y pulse otra vez Buscar tablero.</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Reflejar imágenes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardFloor</name>
    <message>
        <source>Looking for the board in the images shown…</source>
        <translation>Buscando el tablero en las imágenes mostradas…</translation>
    </message>
    <message>
        <source>No camera sees the board well enough: %1. Show images in which the board lies on the floor, or correct the description of the board on the page Board.</source>
        <translation>Ninguna cámara ve lo bastante bien el tablero: %1. Muestre imágenes en que el tablero esté en el suelo, o corrija la descripción del tablero en la página Tablero.</translation>
    </message>
    <message>
        <source>The floor was not set, because the cameras have changed in the meantime. Try again.</source>
        <translation>El suelo no se fijó, porque las cámaras han cambiado entretanto. Inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Set the floor from the board</source>
        <translation>Definir el suelo con el tablero</translation>
    </message>
    <message numerus="yes">
        <source>The floor is set from the board, which %n camera(s) can see (error %1). The world was rotated by %2.</source>
        <translation>
            <numerusform>El suelo se ha definido con el tablero, que ve %n cámara (error %1). El mundo ha girado %2.</numerusform>
            <numerusform>El suelo se ha definido con el tablero, que ven %n cámaras (error %1). El mundo ha girado %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardForm</name>
    <message>
        <source>Print the board</source>
        <translation>Imprimir el tablero</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Tablero de ajedrez</translation>
    </message>
    <message>
        <source>ChArUco (with markers)</source>
        <translation>ChArUco (con marcadores)</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>Tipo de tablero</translation>
    </message>
    <message>
        <source>Squares per row and column</source>
        <translation>Casillas por fila y columna</translation>
    </message>
    <message>
        <source>Squares in a row</source>
        <translation>Casillas por fila</translation>
    </message>
    <message>
        <source>Number of squares in a row, black and white together</source>
        <translation>Número de casillas de una fila, negras y blancas juntas</translation>
    </message>
    <message>
        <source>Squares in a column</source>
        <translation>Casillas por columna</translation>
    </message>
    <message>
        <source>Number of squares in a column, black and white together</source>
        <translation>Número de casillas de una columna, negras y blancas juntas</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Lado de una casilla</translation>
    </message>
    <message>
        <source>Unit of the sizes</source>
        <translation>Unidad de las medidas</translation>
    </message>
    <message>
        <source>Unit of the sizes that you enter</source>
        <translation>Unidad de las medidas que introduce</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>Lado de un marcador</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>Diccionario de los marcadores</translation>
    </message>
    <message>
        <source>The marker dictionary that was chosen when the board was made</source>
        <translation>El diccionario de marcadores que se eligió al crear el tablero</translation>
    </message>
    <message>
        <source>Legacy ChArUco layout</source>
        <translation>Diseño ChArUco antiguo</translation>
    </message>
    <message>
        <source>Inverted colors</source>
        <translation>Colores invertidos</translation>
    </message>
    <message>
        <source>White markers and corners on a black page</source>
        <translation>Marcadores y esquinas blancos sobre una hoja negra</translation>
    </message>
    <message>
        <source>Print this board…</source>
        <translation>Imprimir este tablero…</translation>
    </message>
    <message>
        <source>Save the board as a PDF at its true size, with a scale bar to check with a ruler</source>
        <translation>Guardar el tablero como PDF a tamaño real, con una escala para comprobarla con una regla</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>%1 × %2 inner corners. Description for the command line:</source>
        <translation>%1 × %2 esquinas interiores. Descripción para la línea de órdenes:</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>Diccionario</translation>
    </message>
    <message>
        <source>A ChArUco board may be partly hidden, or partly outside the image; a chessboard must be completely visible</source>
        <translation>Un tablero ChArUco puede estar parcialmente tapado o parcialmente fuera de la imagen; uno de ajedrez debe verse entero</translation>
    </message>
    <message>
        <source>Measure a long row on the print with a ruler, and divide its length by the number of its squares</source>
        <translation>Mida una fila larga de la hoja impresa con una regla y divida su longitud entre el número de sus casillas</translation>
    </message>
    <message>
        <source>Length of one side of a marker, with its black border</source>
        <translation>Longitud de un lado de un marcador, con su borde negro</translation>
    </message>
    <message>
        <source>For ChArUco boards with an even number of rows that were made with software older than OpenCV 4.6: their first square is white</source>
        <translation>Para tableros ChArUco con un número par de filas hechos con programas anteriores a OpenCV 4.6: su primera casilla es blanca</translation>
    </message>
    <message>
        <source>Size of the paper. A larger board is split over several sheets</source>
        <translation>Tamaño del papel. Un tablero más grande se reparte en varias hojas</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardGoalForm</name>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Intrinsics and positions</source>
        <translation>Intrínsecos y posiciones</translation>
    </message>
    <message>
        <source>Intrinsics</source>
        <translation>Parámetros intrínsecos</translation>
    </message>
    <message>
        <source>Camera positions</source>
        <translation>Posiciones de las cámaras</translation>
    </message>
    <message>
        <source>Values to calibrate</source>
        <translation>Valores que se calibran</translation>
    </message>
    <message>
        <source>Intrinsics: lens and sensor, for each camera separately. Positions: where the cameras are, computed from a board that several cameras see at the same time</source>
        <translation>Intrínsecos: lente y sensor, para cada cámara por separado. Posiciones: dónde están las cámaras, calculado con un tablero que varias cámaras ven a la vez</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Modelo de lente</translation>
    </message>
    <message>
        <source>Pinhole, 5 coefficients</source>
        <translation>Estenopeico, 5 coeficientes</translation>
    </message>
    <message>
        <source>Pinhole, 8 coefficients (wide)</source>
        <translation>Estenopeico, 8 coeficientes (gran angular)</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>Ojo de pez</translation>
    </message>
    <message>
        <source>Frame with the board on the floor</source>
        <translation>Fotograma con el tablero en el suelo</translation>
    </message>
    <message>
        <source>Number of the frame with the board on the floor</source>
        <translation>Fotograma en que el tablero está en el suelo</translation>
    </message>
    <message>
        <source>Set to current frame</source>
        <translation>Fotograma actual</translation>
    </message>
    <message>
        <source>Set floor frame to current frame</source>
        <translation>Usar el fotograma actual para el suelo</translation>
    </message>
    <message>
        <source>Enter the number of the frame that is shown now</source>
        <translation>Introducir el número del fotograma que se muestra ahora</translation>
    </message>
    <message>
        <source>Accuracy goal</source>
        <translation>Precisión deseada</translation>
    </message>
    <message>
        <source>Desired accuracy of the intrinsics</source>
        <translation>Precisión deseada de los parámetros intrínsecos</translation>
    </message>
    <message>
        <source>Guidance ends when the intrinsics are this accurate in all parts of the image</source>
        <translation>La guía termina cuando los parámetros intrínsecos tienen esta precisión en toda la imagen</translation>
    </message>
    <message>
        <source>Desired accuracy of the positions</source>
        <translation>Precisión deseada de las posiciones</translation>
    </message>
    <message>
        <source>Guidance ends when the position of each camera is this accurate</source>
        <translation>La guía termina cuando la posición de cada cámara tiene esta precisión</translation>
    </message>
    <message>
        <source>5 coefficients for most lenses, 8 for wide-angle lenses, fisheye for a field of view above about 120°</source>
        <translation>5 coeficientes para la mayoría de las lentes, 8 para gran angular, ojo de pez para un campo de visión de más de unos 120°</translation>
    </message>
    <message>
        <source>The board as it lies in this video frame defines the world coordinates: X along its rows, Y toward its upper edge, Z up from the floor. Without such a frame, the first camera keeps its position</source>
        <translation>El tablero, tal como está en este fotograma del vídeo, define las coordenadas del mundo: X a lo largo de sus filas, Y hacia su borde superior, Z hacia arriba desde el suelo. Sin un fotograma así, la primera cámara conserva su posición</translation>
    </message>
    <message>
        <source>Number of the frame, as in the timeline (the first frame is 1)</source>
        <translation>Número del fotograma, como en la línea de tiempo (el primero es 1)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardLive</name>
    <message>
        <source>Time for which the board was held still in front of %1</source>
        <translation>Tiempo que se mantuvo quieto el tablero ante %1</translation>
    </message>
    <message>
        <source>Positions in which %1 saw the board</source>
        <translation>Posiciones en que %1 vio el tablero</translation>
    </message>
    <message>
        <source>Filled: image regions and tilts in which the board was already shown. Orange: what to show next. Green: the board in the current image</source>
        <translation>Relleno: zonas e inclinaciones en que se mostró el tablero. Naranja: qué mostrar después. Verde: el tablero en la imagen actual</translation>
    </message>
    <message>
        <source>Capture now</source>
        <translation>Capturar ahora</translation>
    </message>
    <message>
        <source>Capture the board as it is shown now, even if it is not held still</source>
        <translation>Capturar el tablero tal como se muestra ahora, aunque no esté quieto</translation>
    </message>
    <message>
        <source>Set floor from board</source>
        <translation>Fijar suelo con tablero</translation>
    </message>
    <message>
        <source>Next: positions</source>
        <translation>Siguiente: posiciones</translation>
    </message>
    <message>
        <source>Accept the current accuracy of the intrinsics; then show the board to several cameras at once</source>
        <translation>Aceptar la precisión actual de los parámetros intrínsecos y mostrar luego el tablero a varias cámaras a la vez</translation>
    </message>
    <message>
        <source>Calibrate with these views</source>
        <translation>Calibrar con estas vistas</translation>
    </message>
    <message>
        <source>Finish now with the views captured so far</source>
        <translation>Terminar ahora con las vistas capturadas hasta el momento</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Find the board in the live images and get guidance on what to show</source>
        <translation>Buscar el tablero en las imágenes en vivo y recibir indicaciones de qué mostrar</translation>
    </message>
    <message>
        <source>Waiting for images. Check that the cameras are running.</source>
        <translation>Esperando imágenes. Compruebe que las cámaras estén en marcha.</translation>
    </message>
    <message>
        <source>Show the board to one camera after the other, following the instructions for each.</source>
        <translation>Muestre el tablero a una cámara tras otra, según las instrucciones de cada una.</translation>
    </message>
    <message>
        <source>Large display…</source>
        <translation>Pantalla grande…</translation>
    </message>
    <message>
        <source>Show what to do next in large letters that can be read from across the room, with a sound for each captured view</source>
        <translation>Mostrar qué hacer a continuación en letras grandes que se lean desde el otro lado de la sala, con un sonido por cada vista capturada</translation>
    </message>
    <message>
        <source>Define the world coordinates with the board that lies on the floor now: X along its rows, Y toward its upper edge, Z up from the floor</source>
        <translation>Definir las coordenadas del mundo con el tablero que está ahora en el suelo: X a lo largo de sus filas, Y hacia su borde superior, Z hacia arriba desde el suelo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxExportDialog</name>
    <message>
        <source>Export boxes</source>
        <translation>Exportar recuadros</translation>
    </message>
    <message>
        <source>First lines of boxes.csv</source>
        <translation>Primeras líneas de boxes.csv</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Folder for both files; it is created if it does not exist</source>
        <translation>Los dos archivos se guardan en esta carpeta; se crea si no existe</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the folder of the files</source>
        <translation>Elegir la carpeta de los archivos</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Write both files (Enter)</source>
        <translation>Escribir ambos archivos (Intro)</translation>
    </message>
    <message>
        <source>Folder of the boxes</source>
        <translation>Carpeta de los recuadros</translation>
    </message>
    <message>
        <source>Saved boxes.csv and boxes_mot.txt in %1.</source>
        <translation>Se guardaron boxes.csv y boxes_mot.txt en %1.</translation>
    </message>
    <message>
        <source>The folder already contains exported boxes. Replace them?</source>
        <translation>La carpeta ya contiene recuadros exportados. ¿Reemplazarlos?</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 ya existe; no se escribió nada.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Two files are written. In boxes.csv, each row has the box of one target in one frame, its center, its similarity, and whether the target was seen or hidden. The file boxes_mot.txt has the format of the MOT challenge. All lengths are in pixels.</source>
        <translation>Se escriben dos archivos. En boxes.csv, cada fila tiene el recuadro de un objetivo en un fotograma, su centro, su similitud y si el objetivo estaba visto u oculto. El archivo boxes_mot.txt tiene el formato del MOT Challenge. Todas las longitudes están en píxeles.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxModel</name>
    <message>
        <source>◌ hidden</source>
        <translation>◌ oculto</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>tiempo, s</translation>
    </message>
    <message>
        <source>Time of the frame, in seconds</source>
        <translation>Tiempo del fotograma, en segundos</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>fotograma</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>Fotograma, contado desde 1</translation>
    </message>
    <message>
        <source>target</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Nombre del objetivo</translation>
    </message>
    <message>
        <source>x, px</source>
        <translation>x, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the left edge of the image</source>
        <translation>Centro del recuadro, píxeles desde el borde izquierdo de la imagen</translation>
    </message>
    <message>
        <source>y, px</source>
        <translation>y, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the upper edge of the image</source>
        <translation>Centro del recuadro, píxeles desde el borde superior de la imagen</translation>
    </message>
    <message>
        <source>width, px</source>
        <translation>anchura, px</translation>
    </message>
    <message>
        <source>Box width (pixels)</source>
        <translation>Anchura del recuadro, píxeles</translation>
    </message>
    <message>
        <source>height, px</source>
        <translation>altura, px</translation>
    </message>
    <message>
        <source>Box height (pixels)</source>
        <translation>Altura del recuadro, píxeles</translation>
    </message>
    <message>
        <source>similarity</source>
        <translation>similitud</translation>
    </message>
    <message>
        <source>Similarity of the colors in the box to the initial colors, 0 to 1</source>
        <translation>Similitud de los colores del recuadro con los iniciales, de 0 a 1</translation>
    </message>
    <message>
        <source>spread, px</source>
        <translation>dispersión, px</translation>
    </message>
    <message>
        <source>state</source>
        <translation>estado</translation>
    </message>
    <message>
        <source>Hidden: the target was not found in this frame; the box shows where it is expected</source>
        <translation>Oculto: no se encontró el objetivo en este fotograma; el recuadro muestra dónde se espera</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● seguido</translation>
    </message>
    <message>
        <source>Root mean square distance of the particles from their mean</source>
        <translation>Distancia cuadrática media de las partículas a su media</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPanel</name>
    <message>
        <source>Boxes of the targets</source>
        <translation>Recuadros de los objetivos</translation>
    </message>
    <message>
        <source>This method tracks boxes in images. Click the object or drag a box around it in any camera view. Its box in each frame appears here, in pixels.</source>
        <translation>Este método sigue recuadros en imágenes. Haga clic en el objeto o dibuje un recuadro a su alrededor en cualquier cámara. Aquí aparece su recuadro en cada fotograma, en píxeles.</translation>
    </message>
    <message numerus="yes">
        <source>%n boxes (coordinates in image pixels)</source>
        <translation>
            <numerusform>%n recuadro (coordenadas en píxeles de la imagen)</numerusform>
            <numerusform>%n recuadros (coordenadas en píxeles de la imagen)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPicker</name>
    <message>
        <source>No box can be set here, because this camera shows no image.</source>
        <translation>No se puede fijar un recuadro aquí, porque esta cámara no muestra ninguna imagen.</translation>
    </message>
    <message>
        <source>Box of %1</source>
        <translation>Recuadro de %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationChoice</name>
    <message>
        <source>Calibration file:</source>
        <translation>Archivo de calibración:</translation>
    </message>
    <message>
        <source>A calibration file of Dewpoint or another program. Cameras are matched by name, or by order if the names differ</source>
        <translation>Un archivo de calibración de Dewpoint o de otro programa. Las cámaras se asignan por nombre o, si los nombres difieren, por orden</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Continue without a calibration file</source>
        <translation>Continuar sin archivo de calibración</translation>
    </message>
    <message>
        <source>Recognized: %1. The file does not contain everything: %2. Create the project without this file, then choose Calibration › Import calibration and enter what is missing.</source>
        <translation>Reconocido: %1. El archivo no lo contiene todo: %2. Cree el proyecto sin este archivo, elija después Calibración › Importar calibración e indique lo que falta.</translation>
    </message>
    <message>
        <source>Recognized: %1. It cannot be used: %2.</source>
        <translation>Reconocido: %1. No se puede usar: %2.</translation>
    </message>
    <message>
        <source>The file cannot be used: %1.</source>
        <translation>El archivo no se puede usar: %1.</translation>
    </message>
    <message>
        <source>Not recognized. Dewpoint reads: %1.</source>
        <translation>No reconocido. Dewpoint lee: %1.</translation>
    </message>
    <message>
        <source>Recognized: %1. The cameras in the file do not match the cameras above: %2.</source>
        <translation>Reconocido: %1. Las cámaras del archivo no concuerdan con las cámaras de arriba: %2.</translation>
    </message>
    <message numerus="yes">
        <source>✓ Recognized: %1, %n cameras</source>
        <translation>
            <numerusform>✓ Reconocido: %1, %n cámara</numerusform>
            <numerusform>✓ Reconocido: %1, %n cámaras</numerusform>
        </translation>
    </message>
    <message>
        <source>None: the camera positions will only be guesses</source>
        <translation>Ninguna: las posiciones de las cámaras serán solo suposiciones</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leyendo…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Importar calibración…</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>Importar una calibración</translation>
    </message>
    <message>
        <source>%1 (found beside the recordings)</source>
        <translation>%1 (encontrado junto a las grabaciones)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationDock</name>
    <message>
        <source>Pages of the camera calibration</source>
        <translation>Páginas de la calibración de cámaras</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationExportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>Elegir una carpeta</translation>
    </message>
    <message>
        <source>Export the calibration</source>
        <translation>Exportar la calibración</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Write the file; an existing file is replaced</source>
        <translation>Escribir el archivo; si existe, se reemplaza</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>The program that will read the file</source>
        <translation>El programa que leerá el archivo</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Unit of lengths, if the format does not define it</source>
        <translation>Unidad de las longitudes, si el formato no la define</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>%1 exists and will be replaced.</source>
        <translation>%1 existe y será reemplazado.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
    <message>
        <source>%1: with the exported calibration, projected points move by at most %2, because the format cannot store this lens model and the lens was fitted again</source>
        <translation>%1: con la calibración exportada, los puntos proyectados se desplazan como mucho %2, porque el formato no puede guardar este modelo de lente y la lente se reajustó</translation>
    </message>
    <message>
        <source>%1: with the exported calibration, projected points move by at most %2</source>
        <translation>%1: con la calibración exportada, los puntos proyectados se desplazan como mucho %2</translation>
    </message>
    <message>
        <source>%1: with the exported lens, %2 of 81 tested directions can no longer be projected into the image</source>
        <translation>%1: con la lente exportada, %2 de 81 direcciones probadas ya no se pueden proyectar en la imagen</translation>
    </message>
    <message>
        <source>default of the format</source>
        <translation>valor habitual del formato</translation>
    </message>
    <message>
        <source>No accuracy is lost: points are projected to the same pixels as before.</source>
        <translation>No se pierde precisión: los puntos se proyectan en los mismos píxeles que antes.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationFit</name>
    <message>
        <source>Change since the calibration:</source>
        <translation>Cambio desde la calibración:</translation>
    </message>
    <message>
        <source>How the images differ from those of the calibration, if they have another size</source>
        <translation>En qué se diferencian las imágenes de las de la calibración, si tienen otro tamaño</translation>
    </message>
    <message>
        <source>Change of the images since the calibration</source>
        <translation>Cambio de las imágenes desde la calibración</translation>
    </message>
    <message>
        <source>For each camera of the project, choose a camera of the file:</source>
        <translation>Para cada cámara del proyecto, elija una cámara del archivo:</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationImportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>Elegir una carpeta</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>Importar una calibración</translation>
    </message>
    <message>
        <source>match by name</source>
        <translation>asignar por nombre</translation>
    </message>
    <message>
        <source>import only for %1</source>
        <translation>importar solo para %1</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Carpeta…</translation>
    </message>
    <message>
        <source>Choose a folder with one file per camera</source>
        <translation>Elegir una carpeta con un archivo por cámara</translation>
    </message>
    <message>
        <source>Use the calibration in the project; you can undo this</source>
        <translation>Usar la calibración en el proyecto; se puede deshacer</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>como en el archivo</translation>
    </message>
    <message>
        <source>detect automatically</source>
        <translation>detectar automáticamente</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>k1 k2 p1 p2 (pinhole)</source>
        <translation>k1 k2 p1 p2 (estenopeica)</translation>
    </message>
    <message>
        <source>k1 k2 k3 k4 (fisheye)</source>
        <translation>k1 k2 k3 k4 (ojo de pez)</translation>
    </message>
    <message>
        <source>from world to camera</source>
        <translation>del mundo a la cámara</translation>
    </message>
    <message>
        <source>from camera to world</source>
        <translation>de la cámara al mundo</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>The program that wrote the file</source>
        <translation>El programa que escribió el archivo</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Unit of the lengths in the file; or enter the length of one unit in meters, such as 0.025 for squares of 25 mm</source>
        <translation>Unidad de las longitudes del archivo; o introduzca la longitud de una unidad en metros, como 0.025 para casillas de 25 mm</translation>
    </message>
    <message>
        <source>Meaning of the four lens coefficients</source>
        <translation>Significado de los cuatro coeficientes de la lente</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Tamaño de imagen</translation>
    </message>
    <message>
        <source>Width and height in pixels, such as 1280x720</source>
        <translation>Anchura y altura en píxeles, como 1280x720</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Poses</translation>
    </message>
    <message>
        <source>Direction of the transformation that the file stores as a pose</source>
        <translation>Sentido de la transformación que el archivo guarda como pose</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Project camera that gets the calibration, if the file contains only one camera</source>
        <translation>Cámara del proyecto que recibe la calibración, si el archivo contiene una sola cámara</translation>
    </message>
    <message>
        <source>The file lacks a required value. Set “%1” above.</source>
        <translation>En el archivo falta un valor necesario. Indique «%1» arriba.</translation>
    </message>
    <message>
        <source>The calibration uses other camera names. The cameras were matched by order.</source>
        <translation>La calibración usa otros nombres de cámara. Las cámaras se asignaron por orden.</translation>
    </message>
    <message>
        <source>%1 (in the file: %2): moves by %3 and rotates by %4</source>
        <translation>%1 (en el archivo: %2): se desplaza %3 y gira %4</translation>
    </message>
    <message>
        <source>Import calibration</source>
        <translation>Importar calibración</translation>
    </message>
    <message>
        <source>The cameras now use the calibration from %1.</source>
        <translation>Las cámaras usan ahora la calibración de %1.</translation>
    </message>
    <message>
        <source>match automatically</source>
        <translation>asignar automáticamente</translation>
    </message>
    <message>
        <source>Project images</source>
        <translation>Imágenes del proyecto</translation>
    </message>
    <message>
        <source>Names in the file</source>
        <translation>Nombres en el archivo</translation>
    </message>
    <message>
        <source>The calibration does not fit the project. Set “%1” above.</source>
        <translation>La calibración no encaja con el proyecto. Indique arriba «%1».</translation>
    </message>
    <message>
        <source>Probably a mistake: %1</source>
        <translation>Probablemente un error: %1</translation>
    </message>
    <message>
        <source>For each camera of the project, choose the camera in the file from which it gets its calibration</source>
        <translation>Elija, para cada cámara del proyecto, la cámara del archivo de la que recibe su calibración</translation>
    </message>
    <message>
        <source>How the images of the project differ from those of the calibration, if they have another size</source>
        <translation>En qué se diferencian las imágenes del proyecto de las de la calibración, si tienen otro tamaño</translation>
    </message>
    <message>
        <source>The file contains no pose. Only the intrinsics are imported; the camera keeps its current pose.</source>
        <translation>El archivo no contiene ninguna pose. Solo se importan los parámetros intrínsecos; la cámara conserva su pose actual.</translation>
    </message>
    <message>
        <source>After the import, projected points are at most %1 away from where the file projects them</source>
        <translation>Tras la importación, los puntos proyectados distan como mucho %1 de donde los proyecta el archivo</translation>
    </message>
    <message>
        <source>Apply calibration</source>
        <translation>Aplicar calibración</translation>
    </message>
    <message>
        <source>default of the format</source>
        <translation>valor habitual del formato</translation>
    </message>
    <message>
        <source>Lens model (4 coefficients)</source>
        <translation>Modelo de lente (4 coeficientes)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationMode</name>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraAgreementAlerts</name>
    <message>
        <source>Calibrate %1…</source>
        <translation>Calibrar %1…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraEdits</name>
    <message numerus="yes">
        <source>Add %n camera(s)</source>
        <translation>
            <numerusform>Añadir %n cámara</numerusform>
            <numerusform>Añadir %n cámaras</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove camera</source>
        <translation>Quitar cámara</translation>
    </message>
    <message>
        <source>Replace camera</source>
        <translation>Sustituir cámara</translation>
    </message>
    <message>
        <source>Exchange cameras</source>
        <translation>Intercambiar cámaras</translation>
    </message>
    <message>
        <source>Rename camera</source>
        <translation>Renombrar la cámara</translation>
    </message>
    <message>
        <source>Rotate images</source>
        <translation>Girar las imágenes</translation>
    </message>
    <message>
        <source>Change image format</source>
        <translation>Cambiar el formato de imagen</translation>
    </message>
    <message>
        <source>Change camera setting</source>
        <translation>Cambiar un ajuste de la cámara</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>Fijar colores</translation>
    </message>
    <message>
        <source>Crop images</source>
        <translation>Recortar imágenes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraForm</name>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>The camera to adjust; you can also click its image</source>
        <translation>La cámara que se ajusta; también puede hacer clic en su imagen</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>Unit of positions</source>
        <translation>Unidad de las posiciones</translation>
    </message>
    <message>
        <source>Unit for showing and entering positions</source>
        <translation>Unidad para mostrar e introducir posiciones</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>point, roll</source>
        <translation>punto, alabeo</translation>
    </message>
    <message>
        <source>yaw, pitch, roll</source>
        <translation>guiñada, cabeceo, alabeo</translation>
    </message>
    <message>
        <source>Direction format</source>
        <translation>Formato de la dirección</translation>
    </message>
    <message>
        <source>Enter the direction as a point that the camera looks at, or as angles: yaw is measured from x toward y, pitch above the horizon, and roll about the line of sight</source>
        <translation>Indique la dirección como un punto al que mira la cámara, o como ángulos: la guiñada se mide de x hacia y, el cabeceo sobre el horizonte y el alabeo alrededor de la línea de visión</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>distancia focal</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>campo de visión</translation>
    </message>
    <message>
        <source>Lens parameter</source>
        <translation>Parámetro de la lente</translation>
    </message>
    <message>
        <source>Focal length in pixels, or the horizontal field of view in degrees</source>
        <translation>Distancia focal en píxeles, o campo de visión horizontal en grados</translation>
    </message>
    <message>
        <source>Focal length or field of view</source>
        <translation>Distancia focal o campo de visión</translation>
    </message>
    <message>
        <source>Magnification of the camera; the keys + and − also change it</source>
        <translation>Aumento de la cámara; las teclas + y − también lo cambian</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Arrastrar</translation>
    </message>
    <message>
        <source>turns the camera</source>
        <translation>gira la cámara</translation>
    </message>
    <message>
        <source>slides the camera</source>
        <translation>desplaza la cámara</translation>
    </message>
    <message>
        <source>Effect of dragging</source>
        <translation>Efecto de arrastrar</translation>
    </message>
    <message>
        <source>What the camera does while you drag the grid and no point is held. Click points of the grid to hold up to three of them.</source>
        <translation>Lo que hace la cámara al arrastrar la cuadrícula sin ningún punto sujeto. Haga clic en puntos de la cuadrícula para sujetar hasta tres.</translation>
    </message>
    <message>
        <source>Also fit the focal length when three points are held</source>
        <translation>Con tres puntos sujetos, ajustar la distancia focal</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>move</source>
        <translation>mover</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>girar</translation>
    </message>
    <message>
        <source>What the keys do to the camera</source>
        <translation>Qué hacen las teclas con la cámara</translation>
    </message>
    <message>
        <source>camera axes</source>
        <translation>ejes de la cámara</translation>
    </message>
    <message>
        <source>world axes</source>
        <translation>ejes del mundo</translation>
    </message>
    <message>
        <source>Axes along which the keys move the camera</source>
        <translation>Ejes a lo largo de los que las teclas mueven la cámara</translation>
    </message>
    <message>
        <source>Move along the camera&apos;s right, forward and up directions, or along the world axes</source>
        <translation>Mover hacia la derecha, adelante y arriba de la cámara, o según los ejes del mundo</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Guiñada</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Cabeceo</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Posición %1</translation>
    </message>
    <message>
        <source>%1 coordinate of the camera&apos;s position</source>
        <translation>Coordenada %1 de la posición de la cámara</translation>
    </message>
    <message>
        <source>Looks at (%1 coordinate)</source>
        <translation>Mira a (coordenada %1)</translation>
    </message>
    <message>
        <source>%1 coordinate of the point that the camera looks at</source>
        <translation>Coordenada %1 del punto al que mira la cámara</translation>
    </message>
    <message>
        <source>Direction seen from above: 0° along x, 90° along y</source>
        <translation>Dirección vista desde arriba: 0° según x, 90° según y</translation>
    </message>
    <message>
        <source>Angle above the horizon; straight down is −90°</source>
        <translation>Ángulo sobre el horizonte; vertical hacia abajo es −90°</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>alabeo</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Alabeo</translation>
    </message>
    <message>
        <source>Clockwise rotation about the line of sight</source>
        <translation>Giro alrededor de la línea de visión, en sentido horario</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>looks at</source>
        <translation>mira a</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>guiñada</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>cabeceo</translation>
    </message>
    <message>
        <source>Three held points fix the pose. With this option, dragging changes the focal length, and the pose is adapted so that the three points stay in place</source>
        <translation>Tres puntos sujetos fijan la pose. Con esta opción, arrastrar cambia la distancia focal, y la pose se adapta para que los tres puntos queden en su sitio</translation>
    </message>
    <message>
        <source>The arrow keys, the page keys and W, A, S, D, Q and E move or turn the camera by 1 cm or 0.2° a step. With Shift, the steps are ten times as large. With Ctrl, the steps of the arrow and page keys are a tenth as large.</source>
        <translation>Las flechas, las teclas de página y W, A, S, D, Q y E mueven o giran la cámara 1 cm o 0,2° por paso. Con Mayús, los pasos son diez veces más grandes. Con Ctrl, los pasos de las flechas y las teclas de página son la décima parte.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraMotionAlerts</name>
    <message>
        <source>%1 was rotated by %2 (frame %3).</source>
        <translation>%1 giró %2 (fotograma %3).</translation>
    </message>
    <message>
        <source>The new pose of this camera is being computed.</source>
        <translation>Se está calculando la nueva pose de esta cámara.</translation>
    </message>
    <message>
        <source>The pose of this camera can be recomputed from its images.</source>
        <translation>La pose de esta cámara se puede recalcular a partir de sus imágenes.</translation>
    </message>
    <message>
        <source>Recompute pose of %1</source>
        <translation>Recalcular pose de %1</translation>
    </message>
    <message>
        <source>The pose of this camera cannot be recomputed from its images: calibrate the camera again, or move it back.</source>
        <translation>La pose de esta cámara no se puede recalcular a partir de sus imágenes: calibre la cámara otra vez o devuélvala a su sitio.</translation>
    </message>
    <message>
        <source>Calibrate %1…</source>
        <translation>Calibrar %1…</translation>
    </message>
    <message>
        <source>%1 is back in its calibrated pose.</source>
        <translation>%1 vuelve a estar en su pose calibrada.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraPanel</name>
    <message>
        <source>Rename camera</source>
        <translation>Renombrar la cámara</translation>
    </message>
    <message>
        <source>Change image source</source>
        <translation>Cambiar el origen de las imágenes</translation>
    </message>
    <message>
        <source>Rotate images</source>
        <translation>Girar las imágenes</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>Nombre de la cámara, en vistas y archivos</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Video file, image folder, device, or stream address</source>
        <translation>Archivo de vídeo, carpeta de imágenes, dispositivo o dirección de un flujo</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the file, folder or device of this camera</source>
        <translation>Elegir el archivo, la carpeta o el dispositivo de esta cámara</translation>
    </message>
    <message>
        <source>Rotated</source>
        <translation>Girada</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulada</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, focal length %3 pixels
Position x, y, z: %4, %5, %6</source>
        <translation>%1 × %2 píxeles, distancia focal %3 píxeles
Posición x, y, z: %4, %5, %6</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Elija una carpeta de imágenes</translation>
    </message>
    <message>
        <source>Choose the video for this camera</source>
        <translation>Elija el vídeo de esta cámara</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Reflejar imágenes</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Reflejada</translation>
    </message>
    <message>
        <source>Mirror the images left to right, after rotation</source>
        <translation>Reflejar las imágenes de izquierda a derecha, tras girarlas</translation>
    </message>
    <message>
        <source>Background image</source>
        <translation>Imagen de fondo</translation>
    </message>
    <message>
        <source>Image, video or image folder that shows the scene without any target. Objects in the background that have the target&apos;s color are then not mistaken for the target</source>
        <translation>Imagen, vídeo o carpeta de imágenes que muestra la escena sin ningún objetivo. Así, los objetos del fondo que tienen el color del objetivo no se confunden con él</translation>
    </message>
    <message>
        <source>Choose background image</source>
        <translation>Elegir la imagen de fondo</translation>
    </message>
    <message>
        <source>Choose an image or a video of the scene without any target</source>
        <translation>Elegir una imagen o un vídeo de la escena sin ningún objetivo</translation>
    </message>
    <message>
        <source>Use current image as background</source>
        <translation>Usar imagen actual como fondo</translation>
    </message>
    <message>
        <source>Save the current image of this camera as its background image</source>
        <translation>Guardar la imagen actual de esta cámara como su imagen de fondo</translation>
    </message>
    <message>
        <source>Change background image</source>
        <translation>Cambiar la imagen de fondo</translation>
    </message>
    <message>
        <source>Choose a background image or video</source>
        <translation>Elegir una imagen o un vídeo de fondo</translation>
    </message>
    <message>
        <source>Change delay</source>
        <translation>Cambiar el retraso</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retraso</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>How late this camera&apos;s images are, in ms. Dewpoint uses this delay to synchronize the cameras. Calibration with a wand can measure the delay</source>
        <translation>Cuánto se retrasan las imágenes de esta cámara, en ms. Dewpoint sincroniza las cámaras con este retraso. La calibración con varita puede medir el retraso</translation>
    </message>
    <message>
        <source>Delay of the images in milliseconds</source>
        <translation>Retraso de las imágenes en milisegundos</translation>
    </message>
    <message>
        <source>Keep estimated delay</source>
        <translation>Conservar el retardo estimado</translation>
    </message>
    <message>
        <source>How far the images are rotated clockwise before they are used. The calibration is rotated with them</source>
        <translation>Cuánto se giran las imágenes en el sentido de las agujas del reloj antes de usarlas. La calibración se gira con ellas</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Importar calibración…</translation>
    </message>
    <message>
        <source>Import the calibration of the cameras from a file of Dewpoint or another program</source>
        <translation>Importar la calibración de las cámaras de un archivo de Dewpoint o de otro programa</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraTable</name>
    <message>
        <source>rtsp://192.168.0.10/stream, or a device number such as 0</source>
        <translation>rtsp://192.168.0.10/stream, o un número de dispositivo, como 0</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leyendo…</translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %3 frames per second · %n frames</source>
        <translation>
            <numerusform>✓ %1×%2 · %3 fotogramas por segundo · %n fotograma</numerusform>
            <numerusform>✓ %1×%2 · %3 fotogramas por segundo · %n fotogramas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %n images</source>
        <translation>
            <numerusform>✓ %1×%2 · %n imagen</numerusform>
            <numerusform>✓ %1×%2 · %n imágenes</numerusform>
        </translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Live source: it is tested when the project is created</source>
        <translation>Fuente en vivo: se prueba al crear el proyecto</translation>
    </message>
    <message>
        <source>The videos have different frame rates: frame N does not show the same time in each of them.</source>
        <translation>Los vídeos tienen distinta frecuencia de fotogramas: el fotograma N no muestra el mismo instante en todos.</translation>
    </message>
    <message numerus="yes">
        <source>The videos differ in length: only the first %n frames are used.</source>
        <translation>
            <numerusform>Los vídeos tienen distinta duración: se usa el primer fotograma (%n).</numerusform>
            <numerusform>Los vídeos tienen distinta duración: se usan los primeros %n fotogramas.</numerusform>
        </translation>
    </message>
    <message>
        <source>The videos differ in size: each camera keeps its own size.</source>
        <translation>Los vídeos tienen distinto tamaño: cada cámara conserva el suyo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CamerasDialog</name>
    <message>
        <source>Cameras – Dewpoint</source>
        <translation>Cámaras – Dewpoint</translation>
    </message>
    <message>
        <source>Fit formats to the USB bus</source>
        <translation>Adaptar formatos al bus USB</translation>
    </message>
    <message>
        <source>These formats fit the USB bus: %1.</source>
        <translation>Estos formatos caben en el bus USB: %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ChangesGuard</name>
    <message>
        <source>Save the project</source>
        <translation>Guardar el proyecto</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml)</source>
        <translation>Proyectos de Dewpoint (*.toml)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save the changes to this project?</source>
        <translation>¿Guardar los cambios de este proyecto?</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorChoice</name>
    <message>
        <source>Color %1</source>
        <translation>Color %1</translation>
    </message>
    <message>
        <source>Show this color, so that its range can be changed by hand</source>
        <translation>Mostrar este color del objetivo, para cambiar su rango a mano</translation>
    </message>
    <message>
        <source>Colors of the target</source>
        <translation>Colores del objetivo</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove this color from the target, and the samples that show it</source>
        <translation>Quitar este color del objetivo, con las muestras que lo enseñan</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorDock</name>
    <message>
        <source>Color</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Set box here</source>
        <translation>Fijar recuadro aquí</translation>
    </message>
    <message>
        <source>Learn the color here</source>
        <translation>Aprender el color aquí</translation>
    </message>
    <message>
        <source>Add color sample here</source>
        <translation>Añadir muestra de color aquí</translation>
    </message>
    <message>
        <source>Exclude this color</source>
        <translation>Excluir este color</translation>
    </message>
    <message>
        <source>Track this object, starting from a box around it</source>
        <translation>Seguir este objeto, a partir de un recuadro a su alrededor</translation>
    </message>
    <message>
        <source>Learn the target&apos;s color from this spot</source>
        <translation>Aprender el color del objetivo en este punto</translation>
    </message>
    <message>
        <source>Add this color to the colors of the target (Shift-click does the same)</source>
        <translation>Añadir este color a los colores del objetivo (Mayús-clic hace lo mismo)</translation>
    </message>
    <message>
        <source>Remove this color from the colors of the target (Ctrl+Shift-click does the same)</source>
        <translation>Excluir este color de los colores del objetivo (Ctrl+Mayús+clic hace lo mismo)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLearner</name>
    <message>
        <source>No color can be learned here, because this camera shows no image.</source>
        <translation>No se puede aprender un color aquí, porque esta cámara no muestra ninguna imagen.</translation>
    </message>
    <message>
        <source>Click the target first. Then exclude colors of other objects.</source>
        <translation>Primero haga clic en el objetivo. Después excluya los colores de otros objetos.</translation>
    </message>
    <message>
        <source>Exclude color</source>
        <translation>Excluir color</translation>
    </message>
    <message>
        <source>Add color sample</source>
        <translation>Añadir muestra de color</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>Aprender color</translation>
    </message>
    <message>
        <source>Remove color sample</source>
        <translation>Quitar muestra de color</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLocker</name>
    <message>
        <source>These settings of %1 cannot be locked: %2.</source>
        <translation>Estos ajustes de %1 no se pueden fijar: %2.</translation>
    </message>
    <message>
        <source>%1 has no control for these settings and may change them automatically: %2.</source>
        <translation>%1 no tiene control para estos ajustes y puede cambiarlos automáticamente: %2.</translation>
    </message>
    <message>
        <source>Only cameras that are connected to this computer can be locked. For network cameras, use their own settings.</source>
        <translation>Solo se pueden fijar las cámaras conectadas a este ordenador. En las cámaras de red, use sus propios ajustes.</translation>
    </message>
    <message>
        <source>The color settings of these cameras are now locked: %1.</source>
        <translation>Los ajustes de color de estas cámaras están ahora fijados: %1.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>These cameras adjust their colors automatically: %1. The learned color may no longer fit when the light changes.</source>
        <translation>Estas cámaras ajustan sus colores automáticamente: %1. Es posible que el color aprendido ya no sirva cuando cambie la luz.</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>Fijar colores</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPanel</name>
    <message>
        <source>Analyzing images…</source>
        <translation>Analizando imágenes…</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>Aún sin objetivo</translation>
    </message>
    <message>
        <source>A new target</source>
        <translation>Un objetivo nuevo</translation>
    </message>
    <message>
        <source>Click the object to track in any camera image.</source>
        <translation>Haga clic en cualquier imagen en el objeto que quiere seguir.</translation>
    </message>
    <message>
        <source>Change color range</source>
        <translation>Cambiar el intervalo de color</translation>
    </message>
    <message>
        <source>Click the object to track</source>
        <translation>Haga clic en el objeto que quiere seguir</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it</source>
        <translation>Haga clic en el objeto o dibuje un recuadro a su alrededor</translation>
    </message>
    <message>
        <source>The target is tracked from its box in frame %2 of %1 (%3 × %4 pixels). This method needs no color. To set another box, press Box and click the object.</source>
        <translation>El objetivo se sigue desde su recuadro en el fotograma %2 de %1 (%3 × %4 píxeles). Este método no necesita color. Para otro recuadro, pulse Recuadro y haga clic en el objeto.</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>Haga clic en el objeto o dibuje un recuadro a su alrededor en cualquier cámara.</translation>
    </message>
    <message>
        <source>Remove color</source>
        <translation>Quitar color</translation>
    </message>
    <message>
        <source>To set the target&apos;s color, drag the ring and the bars, or press Learn and click the target.</source>
        <translation>Para definir el color del objetivo, arrastre el anillo y las barras, o pulse Aprender y haga clic en el objetivo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPicker</name>
    <message>
        <source>H&amp;ue</source>
        <translation>&amp;Tono</translation>
    </message>
    <message>
        <source>&amp;Saturation</source>
        <translation>&amp;Saturación</translation>
    </message>
    <message>
        <source>&amp;Intensity</source>
        <translation>&amp;Intensidad</translation>
    </message>
    <message>
        <source>Start of the hue range, 0 to 360 degrees. If it is larger than the end, the range passes through red (0 degrees)</source>
        <translation>Inicio del rango de tonos, de 0 a 360 grados. Si es mayor que el final, el rango pasa por el rojo (0 grados)</translation>
    </message>
    <message>
        <source>End of the hue range, 0 to 360 degrees</source>
        <translation>Final del rango de tonos, de 0 a 360 grados</translation>
    </message>
    <message>
        <source>Drag the ends or the center of the range. Keyboard: Tab selects a handle, arrow keys move it (ten times as far with Shift)</source>
        <translation>Arrastre los extremos o el centro del rango. Teclado: Tab elige un control, las flechas lo mueven (con Mayús, diez veces más)</translation>
    </message>
    <message>
        <source>Range of hues</source>
        <translation>Intervalo de tonos</translation>
    </message>
    <message>
        <source>Range of saturation</source>
        <translation>Intervalo de saturación</translation>
    </message>
    <message>
        <source>Range of intensity</source>
        <translation>Intervalo de intensidad</translation>
    </message>
    <message>
        <source>Smallest saturation, 0 to 1</source>
        <translation>Saturación mínima, de 0 a 1</translation>
    </message>
    <message>
        <source>Largest saturation, 0 to 1</source>
        <translation>Saturación máxima, de 0 a 1</translation>
    </message>
    <message>
        <source>Smallest intensity, 0 to 1</source>
        <translation>Intensidad mínima, de 0 a 1</translation>
    </message>
    <message>
        <source>Largest intensity, 0 to 1</source>
        <translation>Intensidad máxima, de 0 a 1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorSampleList</name>
    <message>
        <source>Learned from</source>
        <translation>Aprendido de</translation>
    </message>
    <message>
        <source>Samples from which the color was learned</source>
        <translation>Muestras de las que se aprendió el color</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>excluded: %1, frame %2, pixel %3, %4</source>
        <translation>excluida: %1, fotograma %2, píxel %3, %4</translation>
    </message>
    <message>
        <source>%1, frame %2, pixel %3, %4</source>
        <translation>%1, fotograma %2, píxel %3, %4</translation>
    </message>
    <message>
        <source>Remove the selected sample and learn from the others (Del). If the sample is marked “found”, it becomes an excluded sample.</source>
        <translation>Quitar la muestra elegida y aprender de las demás (Supr). Si la muestra está marcada como «encontrada», pasa a ser una muestra excluida.</translation>
    </message>
    <message>
        <source>Shift-click in an image to add a sample, Ctrl+Shift-click or Alt-click to exclude one. Samples marked “found” were detected in other cameras.</source>
        <translation>Mayús+clic en una imagen añade una muestra; Ctrl+Mayús+clic o Alt+clic excluye una. Las muestras marcadas como «encontrada» se detectaron en otras cámaras.</translation>
    </message>
    <message>
        <source>found: %1, frame %2, pixel %3, %4</source>
        <translation>encontrada: %1, fotograma %2, píxel %3, %4</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>¿Qué quiere hacer?</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Buscar acciones</translation>
    </message>
    <message>
        <source>Actions found</source>
        <translation>Acciones encontradas</translation>
    </message>
    <message>
        <source>No action is called “%1”.</source>
        <translation>Ninguna acción se llama «%1».</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ControlForm</name>
    <message>
        <source>From %1 to %2; default %3</source>
        <translation>De %1 a %2; valor predeterminado %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionMode</name>
    <message>
        <source>Correct position</source>
        <translation>Corregir la posición</translation>
    </message>
    <message>
        <source>There is no correction in this frame.</source>
        <translation>No hay ninguna corrección en este fotograma.</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Quitar la corrección</translation>
    </message>
    <message>
        <source>Set the target&apos;s position in this frame to this point; tracking continues from there</source>
        <translation>Fijar la posición del objetivo en este fotograma en este punto; el seguimiento continúa desde ahí</translation>
    </message>
    <message>
        <source>Drag the target to its true position in one image. To set its depth as well, do the same in a second image. Press Esc to finish.</source>
        <translation>Arrastre el objetivo a su posición real en una imagen. Para fijar también su profundidad, haga lo mismo en otra imagen. Pulse Esc para terminar.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionTool</name>
    <message>
        <source>Drag the target to its true position</source>
        <translation>Arrastre el objetivo a su posición real</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter sets the target&apos;s position there</source>
        <translation>Imagen de %1: las flechas mueven una cruz, Intro fija ahí la posición del objetivo</translation>
    </message>
    <message>
        <source>There is no target yet: learn its color first.</source>
        <translation>Aún no hay ningún objetivo: aprenda primero su color.</translation>
    </message>
    <message>
        <source>Frames are being tracked again: wait until tracking has finished, or pause it.</source>
        <translation>Se están siguiendo fotogramas otra vez: espere a que termine el seguimiento, o póngalo en pausa.</translation>
    </message>
    <message>
        <source>Select a target in the panel Target first, or drag the estimate of a target.</source>
        <translation>Elija primero un objetivo en el panel Objetivo, o arrastre la estimación de un objetivo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CoverageMap</name>
    <message>
        <source>%1: %2 detections, in %3 of %4 regions of the image</source>
        <translation>%1: %2 detecciones, en %3 de %4 zonas de la imagen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CrashReports</name>
    <message>
        <source>Dewpoint closed unexpectedly last time and left a report of what happened.</source>
        <translation>La última vez, Dewpoint se cerró inesperadamente. Dejó un informe de lo ocurrido.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Mostrar informe</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CropForm</name>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>top</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>abajo</translation>
    </message>
    <message>
        <source>Pixels to cut off at this edge, after rotation and mirroring. The calibration is converted. Color samples and boxes in the part that is cut off are removed; Undo brings them back</source>
        <translation>Píxeles que se recortan en este borde, después de girar y reflejar. La calibración se convierte. Las muestras de color y los recuadros de la parte recortada se eliminan; Deshacer los recupera</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DelayEstimate</name>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Add the estimated delay to the delay of this camera in the project</source>
        <translation>Sumar el retardo estimado al retardo de esta cámara en el proyecto</translation>
    </message>
    <message>
        <source>This delay is estimated from the motion of the targets, and corrected while tracking. To switch this off, set the parameter “Delay spread” to 0</source>
        <translation>Este retardo se estima a partir del movimiento de los objetivos y se corrige durante el seguimiento. Para desactivarlo, ponga el parámetro «Dispersión de los retardos» a 0</translation>
    </message>
    <message>
        <source>Estimate: %1 later than %2, ±%3</source>
        <translation>Estimación: %1 más tarde que %2, ±%3</translation>
    </message>
    <message>
        <source>Estimate: %1 earlier than %2, ±%3</source>
        <translation>Estimación: %1 antes que %2, ±%3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DeviceQuestion</name>
    <message>
        <source>Use %1</source>
        <translation>Usar %1</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>Cámaras…</translation>
    </message>
    <message>
        <source>Several devices may be the camera %1 (%2). Which one is it?</source>
        <translation>Varios dispositivos pueden ser la cámara %1 (%2). ¿Cuál es?</translation>
    </message>
    <message>
        <source>The device of the camera %1 is not connected: %2. Plug it in, or choose another one.</source>
        <translation>El dispositivo de la cámara %1 no está conectado: %2. Conéctelo o elija otro.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DockTitle</name>
    <message>
        <source>Float or dock this view (to maximize the view, double-click its title)</source>
        <translation>Soltar o acoplar esta vista (doble clic en su título la maximiza)</translation>
    </message>
    <message>
        <source>Show all views</source>
        <translation>Mostrar todas las vistas</translation>
    </message>
    <message>
        <source>Restore the other views (Esc, or double-click here)</source>
        <translation>Restaurar las demás vistas (Esc, o doble clic aquí)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Document</name>
    <message>
        <source>Change “%1”</source>
        <translation>Cambiar «%1»</translation>
    </message>
    <message>
        <source>Track with method “%1”</source>
        <translation>Seguir con el método «%1»</translation>
    </message>
    <message>
        <source>Reset “%1”</source>
        <translation>Restablecer «%1»</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Restablecer todos los parámetros</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DropZone</name>
    <message>
        <source>Drop or click to add videos</source>
        <translation>Suelte vídeos o haga clic aquí</translation>
    </message>
    <message>
        <source>One video or image folder per camera; you can also drop a calibration file</source>
        <translation>Un vídeo o una carpeta de imágenes por cámara; también puede soltar un archivo de calibración</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExchangeDialog</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>The file, or the folder with a file for each camera</source>
        <translation>El archivo, o la carpeta con un archivo por cámara</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Elegir el archivo</translation>
    </message>
    <message>
        <source>Choose the file to read or write</source>
        <translation>Buscar el archivo</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Choose a file. A preview of the result is shown here before anything changes.</source>
        <translation>Elija un archivo. Aquí se muestra una vista previa del resultado antes de cambiar nada.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close without changing anything</source>
        <translation>Cerrar sin cambiar nada</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExperimentDialog</name>
    <message>
        <source>Canceled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Experimentos</translation>
    </message>
    <message>
        <source>Folder for the report, its pictures and its numbers</source>
        <translation>Carpeta para el informe, sus imágenes y sus números</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the folder of the report</source>
        <translation>Elegir la carpeta del informe</translation>
    </message>
    <message>
        <source>Experiment progress</source>
        <translation>Progreso del experimento</translation>
    </message>
    <message>
        <source>Run the chosen experiment (Enter)</source>
        <translation>Ejecutar el experimento elegido (Intro)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop the experiment without writing anything</source>
        <translation>Detener el experimento sin escribir nada</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Abrir el informe</translation>
    </message>
    <message>
        <source>Show the last report in the web browser</source>
        <translation>Mostrar el último informe en el navegador</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>Carpeta del informe</translation>
    </message>
    <message>
        <source>Choose the folder for the report first.</source>
        <translation>Elija primero la carpeta para el informe.</translation>
    </message>
    <message>
        <source>Running “%1”…</source>
        <translation>Ejecutando «%1»…</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>El informe está en %1.</translation>
    </message>
    <message>
        <source>Runs per case</source>
        <translation>Ejecuciones por caso</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>Recordings folder</source>
        <translation>Carpeta de las grabaciones</translation>
    </message>
    <message>
        <source>Clothes</source>
        <translation>Ropa</translation>
    </message>
    <message>
        <source>Whether the simulated people wear different clothes</source>
        <translation>Si las personas simuladas llevan ropa distinta</translation>
    </message>
    <message>
        <source>both kinds</source>
        <translation>ambas clases</translation>
    </message>
    <message>
        <source>different</source>
        <translation>distinta</translation>
    </message>
    <message>
        <source>similar</source>
        <translation>parecida</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Grabaciones</translation>
    </message>
    <message>
        <source>no folder: only a rendered clip</source>
        <translation>sin carpeta: solo un vídeo generado</translation>
    </message>
    <message>
        <source>Folder with the recordings juggle1 and otb; without a folder, only a rendered clip is used</source>
        <translation>Carpeta con las grabaciones juggle1 y otb; sin carpeta solo se usa un vídeo generado</translation>
    </message>
    <message>
        <source>Choose the folder of the recordings</source>
        <translation>Elegir la carpeta de las grabaciones</translation>
    </message>
    <message>
        <source>How often each case is run, each time with another seed. More runs take longer and give more certain results.</source>
        <translation>Cuántas veces se ejecuta cada caso, cada vez con otra semilla. Más ejecuciones tardan más y dan resultados más seguros.</translation>
    </message>
    <message>
        <source>No program was found that can show the report. The report is in %1.</source>
        <translation>No se encontró ningún programa que pueda mostrar el informe. El informe está en %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportDialog</name>
    <message>
        <source>Export trajectory</source>
        <translation>Exportar la trayectoria</translation>
    </message>
    <message>
        <source>Save figure</source>
        <translation>Guardar figura</translation>
    </message>
    <message>
        <source>Figures (*.svg *.pdf)</source>
        <translation>Figuras (*.svg *.pdf)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>tiempo (s)</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>desde arriba</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>La exportación se canceló.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Archivo que se escribe</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Examinar…</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>Elegir el archivo que se escribe</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop the export or the preview; files that already exist stay unchanged</source>
        <translation>Detener la exportación o la vista previa; los archivos existentes no cambian</translation>
    </message>
    <message>
        <source>Figure…</source>
        <translation>Figura…</translation>
    </message>
    <message>
        <source>Save a figure of the trajectory as SVG or PDF: x, y, z over time, and the view from above</source>
        <translation>Guardar una figura de la trayectoria como SVG o PDF: x, y, z en el tiempo y la vista desde arriba</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Write the file in the background</source>
        <translation>Escribir el archivo en segundo plano</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; a running export continues</source>
        <translation>Cerrar; una exportación en curso continúa</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 ya existe; no se escribió nada.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>The program that will read the file</source>
        <translation>El programa que leerá el archivo</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Only checked targets are exported; if none is checked, all are exported</source>
        <translation>Solo se exportan los objetivos marcados; si no hay ninguno marcado, todos</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>Estimaciones</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frecuencia</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Huecos</translation>
    </message>
    <message>
        <source>What to write while the position is unknown</source>
        <translation>Qué escribir mientras la posición es desconocida</translation>
    </message>
    <message>
        <source>Longest gap</source>
        <translation>Hueco más largo</translation>
    </message>
    <message>
        <source>Longest gap to fill, 0.01 to 60 s</source>
        <translation>Hueco más largo que se rellena, de 0,01 a 60 s</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Ejes del mundo</translation>
    </message>
    <message>
        <source>Axis that points up in the file</source>
        <translation>Eje que apunta hacia arriba en el archivo</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longitudes</translation>
    </message>
    <message>
        <source>Unit of positions in the file</source>
        <translation>Unidad de las posiciones en el archivo</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>el principio</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>el final</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>como se grabó</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> por segundo</translation>
    </message>
    <message>
        <source>smoothed after the run</source>
        <translation>suavizadas tras la ejecución</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>dejar</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>rellenar</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z hacia arriba</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y hacia arriba</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>Earliest time to export, 0 to 1,000,000 s</source>
        <translation>Primer instante que se exporta, de 0 a 1.000.000 s</translation>
    </message>
    <message>
        <source>Latest time to export, 0 to 1,000,000 s</source>
        <translation>Último instante que se exporta, de 0 a 1.000.000 s</translation>
    </message>
    <message>
        <source>Rows per second, 0.001 to 10,000. Positions between frames are interpolated</source>
        <translation>Filas por segundo, de 0,001 a 10.000. Las posiciones entre fotogramas se interpolan</translation>
    </message>
    <message>
        <source>As tracked: estimated during the run, from earlier frames alone. Smoothed: estimated after the run, from earlier and later frames</source>
        <translation>Como se siguieron: estimadas durante la ejecución, solo con los fotogramas anteriores. Suavizadas: estimadas tras la ejecución, con los anteriores y los posteriores</translation>
    </message>
    <message>
        <source>Notes at the top of the file</source>
        <translation>Notas al principio del archivo</translation>
    </message>
    <message>
        <source>Lines that describe the run: method, seed, parameters, units and axes. Without them, a CSV file begins with the names of its columns. TRC and C3D files have no notes</source>
        <translation>Líneas que describen la ejecución: método, semilla, parámetros, unidades y ejes. Sin ellas, un archivo CSV empieza con los nombres de sus columnas. Los archivos TRC y C3D no tienen notas</translation>
    </message>
    <message>
        <source>as tracked (live)</source>
        <translation>como se siguieron (en vivo)</translation>
    </message>
    <message>
        <source>%1 (usual for this format)</source>
        <translation>%1 (habitual en este formato)</translation>
    </message>
    <message>
        <source>tracked only up to %1</source>
        <translation>seguido solo hasta %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportOutcome</name>
    <message>
        <source>Show in folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
    <message>
        <source>Open the folder of the file that was written</source>
        <translation>Abrir la carpeta del archivo escrito</translation>
    </message>
    <message>
        <source>No file manager was found. The path of the file is %1.</source>
        <translation>No se encontró ningún gestor de archivos. La ruta del archivo es %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExposureBars</name>
    <message>
        <source>Brightness of the target&apos;s pixels</source>
        <translation>Brillo de los píxeles del objetivo</translation>
    </message>
    <message>
        <source>Brightness of the target&apos;s pixels, from black on the left to white on the right. The highlighted bars at the two ends count pixels that are too dark or overexposed: these pixels have lost their color.</source>
        <translation>Brillo de los píxeles del objetivo, de negro a la izquierda a blanco a la derecha. Las barras resaltadas de los dos extremos cuentan los píxeles demasiado oscuros o sobreexpuestos: estos píxeles han perdido su color.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExposureView</name>
    <message>
        <source>Exposure: no target is visible in this camera</source>
        <translation>Exposición: no se ve ningún objetivo en esta cámara</translation>
    </message>
    <message>
        <source>Exposure of %1</source>
        <translation>Exposición de %1</translation>
    </message>
    <message>
        <source>%1 % overexposed · %2 % too dark</source>
        <translation>%1 % sobreexpuestos · %2 % demasiado oscuros</translation>
    </message>
    <message>
        <source>%1: %2 % of the target&apos;s pixels are overexposed. Lower the exposure.</source>
        <translation>%1: el %2 % de los píxeles del objetivo están sobreexpuestos. Reduzca la exposición.</translation>
    </message>
    <message>
        <source>%1: %2 % of the target&apos;s pixels are too dark. Raise the exposure, or add light.</source>
        <translation>%1: el %2 % de los píxeles del objetivo son demasiado oscuros. Aumente la exposición o añada luz.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FollowAllButton</name>
    <message numerus="yes">
        <source>Follow all %n objects</source>
        <translation>
            <numerusform>Seguir %n objeto</numerusform>
            <numerusform>Seguir los %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a target for each of the other objects of this color and size</source>
        <translation>Añadir un objetivo por cada uno de los otros objetos de este color y tamaño</translation>
    </message>
    <message>
        <source>Follow all objects of one color</source>
        <translation>Seguir todos los objetos de un color</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FormatChoice</name>
    <message>
        <source>automatic</source>
        <translation>automática</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Format in which the device sends its images. Compressed formats, such as MJPG, use less of the bandwidth of the USB bus</source>
        <translation>Formato en que el dispositivo envía sus imágenes. Los formatos comprimidos, como MJPG, ocupan menos ancho de banda del bus USB</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Size of the images, in pixels</source>
        <translation>Tamaño de las imágenes en píxeles</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frecuencia</translation>
    </message>
    <message>
        <source>Images per second</source>
        <translation>Imágenes por segundo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FrameField</name>
    <message>
        <source>Frame, or time in s</source>
        <translation>Fotograma, o tiempo en s</translation>
    </message>
    <message>
        <source>Frame number or time to go to</source>
        <translation>Número de fotograma o tiempo al que ir</translation>
    </message>
    <message>
        <source>Enter a frame from %1 to %2, or a time from %3 to %4.</source>
        <extracomment>%1 and %2 are numbers of frames, %3 and %4 times</extracomment>
        <translation>Introduzca un fotograma de %1 a %2, o un tiempo de %3 a %4.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GalleryCard</name>
    <message>
        <source>Opening…</source>
        <translation>Abriendo…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GapList</name>
    <message>
        <source>Gaps of the trajectory</source>
        <translation>Huecos de la trayectoria</translation>
    </message>
    <message>
        <source>gap from</source>
        <translation>hueco desde</translation>
    </message>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>length</source>
        <translation>duración</translation>
    </message>
    <message>
        <source>target</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>fotograma %1</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n fotograma</numerusform>
            <numerusform>%n fotogramas</numerusform>
        </translation>
    </message>
    <message>
        <source>Time in seconds between the last tracked frame before the gap and the first tracked frame after it</source>
        <translation>Tiempo en segundos entre el último fotograma seguido antes del hueco y el primero después</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridForm</name>
    <message>
        <source>Change the reference grid</source>
        <translation>Cambiar la cuadrícula de referencia</translation>
    </message>
    <message>
        <source>Grid on</source>
        <translation>Cuadrícula en</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>el suelo</translation>
    </message>
    <message>
        <source>a wall</source>
        <translation>una pared</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>una caja</translation>
    </message>
    <message>
        <source>Kind of grid</source>
        <translation>Tipo de cuadrícula</translation>
    </message>
    <message>
        <source>Surface of the room on which the grid lies</source>
        <translation>Superficie de la sala en la que está la cuadrícula</translation>
    </message>
    <message>
        <source>Size along x, y, z</source>
        <translation>Tamaño según x, y, z</translation>
    </message>
    <message>
        <source>Origin x, y, z</source>
        <translation>Origen x, y, z</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>Tamaño según %1</translation>
    </message>
    <message>
        <source>Size of the grid, in meters</source>
        <translation>Tamaño de la cuadrícula, en metros</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Origen %1</translation>
    </message>
    <message>
        <source>Spacing, rotation</source>
        <translation>Paso, giro</translation>
    </message>
    <message>
        <source>Spacing of the grid</source>
        <translation>Espaciado de la cuadrícula</translation>
    </message>
    <message>
        <source>Distance between lines, in meters</source>
        <translation>Distancia entre líneas, en metros</translation>
    </message>
    <message>
        <source>Rotation of the grid</source>
        <translation>Giro de la cuadrícula</translation>
    </message>
    <message>
        <source>Rotation about the vertical, counterclockwise as seen from above</source>
        <translation>Giro alrededor de la vertical, en sentido antihorario visto desde arriba</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Opacity of the grid</source>
        <translation>Opacidad de la cuadrícula</translation>
    </message>
    <message>
        <source>How strongly the grid is drawn over the images</source>
        <translation>Con qué fuerza se dibuja la cuadrícula sobre las imágenes</translation>
    </message>
    <message>
        <source>Show image edges</source>
        <translation>Mostrar los bordes</translation>
    </message>
    <message>
        <source>Dim the images except for their edges</source>
        <translation>Atenuar las imágenes salvo sus bordes</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Position of the corner at which the axes of the grid start, in meters</source>
        <translation>Posición de la esquina en que empiezan los ejes de la cuadrícula, en metros</translation>
    </message>
    <message>
        <source>Show the grid with the camera poses before the changes</source>
        <translation>Mostrar la cuadrícula con las poses de las cámaras antes de los cambios</translation>
    </message>
    <message>
        <source>Hold down this button to draw the grid with earlier camera poses. Choose below which earlier poses are used. The key B does the same after you have clicked an image</source>
        <translation>Mantenga pulsado este botón para dibujar la cuadrícula con poses anteriores de las cámaras. Elija abajo qué poses anteriores se usan. La tecla B hace lo mismo después de hacer clic en una imagen</translation>
    </message>
    <message>
        <source>Before shows</source>
        <translation>Antes muestra</translation>
    </message>
    <message>
        <source>poses when the panel was opened</source>
        <translation>cámaras al abrir el panel</translation>
    </message>
    <message>
        <source>poses before the last change</source>
        <translation>cámaras antes del último cambio</translation>
    </message>
    <message>
        <source>Earlier camera poses that the button Before shows</source>
        <translation>Poses anteriores de las cámaras que muestra el botón Antes</translation>
    </message>
    <message>
        <source>The cameras as they were when you opened this panel, or as they were before the last step that changed a camera</source>
        <translation>Las cámaras como estaban al abrir este panel, o como estaban antes del último paso que cambió una cámara</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridLayer</name>
    <message>
        <source>Grid over the image of %1</source>
        <translation>Cuadrícula sobre la imagen de %1</translation>
    </message>
    <message>
        <source>Drag the grid onto the real scene. Click a point to hold it. Arrow keys, W A S D, Q and E move or rotate the camera</source>
        <translation>Arrastre la cuadrícula sobre la escena real. Un clic sujeta un punto. Flechas, W A S D, Q y E mueven o giran la cámara</translation>
    </message>
    <message>
        <source>before</source>
        <translation>antes</translation>
    </message>
    <message>
        <source>The earlier grid is outside the visible part of the image</source>
        <translation>La cuadrícula anterior está fuera de la parte visible de la imagen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GuidePage</name>
    <message>
        <source>Calibrate…</source>
        <translation>Calibrar…</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Calibration so far</source>
        <translation>Calibración hasta ahora</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retraso</translation>
    </message>
    <message>
        <source>Calibration of each camera so far</source>
        <translation>Calibración de cada cámara hasta ahora</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Show the previous step</source>
        <translation>Mostrar el paso anterior</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Show the next step</source>
        <translation>Mostrar el paso siguiente</translation>
    </message>
    <message>
        <source>%1 Scale: %2</source>
        <translation>%1 Escala: %2</translation>
    </message>
    <message>
        <source>%1 Floor and upward direction: %2</source>
        <translation>%1 Suelo y dirección hacia arriba: %2</translation>
    </message>
    <message>
        <source>✓ Accuracy in the calibrated volume: %1 (95 %)</source>
        <translation>✓ Exactitud en el volumen calibrado: %1 (95 %)</translation>
    </message>
    <message>
        <source>○ Accuracy in the calibrated volume: not measured</source>
        <translation>○ Exactitud en el volumen calibrado: no medida</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Paso %1 de %2: %3</translation>
    </message>
    <message>
        <source>Another way…</source>
        <translation>Otra forma…</translation>
    </message>
    <message>
        <source>Choose a way to calibrate</source>
        <translation>Elija una forma de calibrar</translation>
    </message>
    <message>
        <source>The camera positions are only guesses. Calibrate the cameras to get correct 3D positions.</source>
        <translation>Las posiciones de las cámaras son solo suposiciones. Calibre las cámaras para obtener posiciones 3D correctas.</translation>
    </message>
    <message>
        <source>✓ measured with this program; ± is the standard deviation. ○ entered, set by hand or read from a file, and not checked. ⚠ only a guess, or too inaccurate.</source>
        <translation>✓ medido con este programa; ± es la desviación típica. ○ introducido, ajustado a mano o leído de un archivo, y no comprobado. ⚠ solo una suposición, o demasiado impreciso.</translation>
    </message>
    <message>
        <source>Show all ways to calibrate. The calibration so far is kept.</source>
        <translation>Mostrar todas las formas de calibrar. La calibración hecha hasta ahora se conserva.</translation>
    </message>
    <message>
        <source>✓ Length check: you measured %1, the calibration gives %2</source>
        <translation>✓ Comprobación de longitud: usted midió %1, la calibración da %2</translation>
    </message>
    <message>
        <source>○ Accuracy outside this volume: %1 (95 %, extrapolated)</source>
        <translation>○ Exactitud fuera de este volumen: %1 (95 %, extrapolado)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistogramView</name>
    <message>
        <source>Colors of the box</source>
        <translation>Colores del recuadro</translation>
    </message>
    <message>
        <source>Color histograms of the bounding box: outlined bars for the reference, filled bars for the current frame. The largest of the 512 bins are shown, each in its own color.</source>
        <translation>Histogramas de color del recuadro: barras huecas, como se indicó; barras llenas, como es ahora. Se muestran las mayores de 512 clases, cada una en su color.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistoryDock</name>
    <message>
        <source>Initial state</source>
        <translation>Estado inicial</translation>
    </message>
    <message>
        <source>History of changes</source>
        <translation>Historial de cambios</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Deshacer: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rehacer: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ImagePickTool</name>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter clicks there</source>
        <translation>Imagen de %1: las flechas mueven una cruz, Intro hace clic ahí</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LearnModes</name>
    <message>
        <source>What a click in an image does</source>
        <translation>Qué hace un clic en una imagen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Recuadro</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Aprender</translation>
    </message>
    <message>
        <source>Add sample</source>
        <translation>Añadir muestra</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Learn the color first: click the target in a camera image.</source>
        <translation>Aprenda primero el color: haga clic en el objetivo en una imagen de cámara.</translation>
    </message>
    <message>
        <source>Click: exclude a color · Esc: stop</source>
        <translation>Clic: excluir un color · Esc: terminar</translation>
    </message>
    <message>
        <source>Click the object in a camera image, or drag a box around it.
When this button is off, Shift-click does the same.</source>
        <translation>Haga clic en el objeto en una imagen, o dibuje un recuadro a su alrededor.
Si este botón está desactivado, Mayús-clic hace lo mismo.</translation>
    </message>
    <message>
        <source>Click another part of the target, or the target in different light, to add its color.
When this button is off, Shift-click does the same.</source>
        <translation>Haga clic en otra parte del objetivo, o en el objetivo con otra luz, para añadir su color.
Si este botón está desactivado, Mayús-clic hace lo mismo.</translation>
    </message>
    <message>
        <source>Click the target in a camera image, or drag a box around it,
to learn its color again.</source>
        <translation>Haga clic en el objetivo en una imagen de cámara, o arrastre un recuadro
alrededor, para aprender de nuevo su color.</translation>
    </message>
    <message>
        <source>Click something that has the target&apos;s color but is not the target, to exclude it.
When this button is off, Ctrl+Shift-click does the same; so does Alt-click, where the desktop does not use it.</source>
        <translation>Haga clic en algo que tiene el color del objetivo pero no es el objetivo, para excluirlo.
Si este botón está desactivado, Ctrl+Mayús+clic hace lo mismo; también Alt+clic, si el escritorio no lo usa.</translation>
    </message>
    <message>
        <source>Click: add a sample · Ctrl+Shift: exclude · Esc: stop</source>
        <translation>Clic: añadir una muestra · Ctrl+Mayús: excluir · Esc: terminar</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Ctrl+Shift: exclude · Esc: stop</source>
        <translation>Clic: aprender · Mayús: añadir · Ctrl+Mayús: excluir · Esc: terminar</translation>
    </message>
    <message>
        <source>Click: add a sample · Esc: stop</source>
        <translation>Clic: añadir una muestra · Esc: terminar</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Esc: stop</source>
        <translation>Clic: aprender · Mayús: añadir · Esc: terminar</translation>
    </message>
    <message>
        <source>Click the new target · Esc: stop</source>
        <translation>Haga clic en el objetivo nuevo · Esc: terminar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LegendPicture</name>
    <message>
        <source>Cross: the estimate, the weighted mean of the particles.</source>
        <translation>Cruz: la estimación, la media ponderada de las partículas.</translation>
    </message>
    <message>
        <source>Solid ellipse: the target is inside with a probability of 95 %. A smaller ellipse is more certain.</source>
        <translation>Elipse continua: el objetivo está dentro con una probabilidad del 95 %. Una elipse menor es más segura.</translation>
    </message>
    <message>
        <source>White diamond: the true position of the target, known only in simulated scenes such as the demo.</source>
        <translation>Rombo blanco: la posición verdadera del objetivo, conocida solo en escenas simuladas, como la demostración.</translation>
    </message>
    <message>
        <source>Triangle: the particle of highest weight (View › Show best particle).</source>
        <translation>Triángulo: la partícula de mayor peso (Ver › Mostrar la mejor partícula).</translation>
    </message>
    <message>
        <source>Line across the image: the line of sight of another camera, shown while you drag the target. The target must lie on this line.</source>
        <translation>Línea a través de la imagen: la línea de visión de otra cámara, que se muestra mientras arrastra el objetivo. El objetivo debe estar sobre esta línea.</translation>
    </message>
    <message>
        <source>Dots: particles. Each one is a guess of where the target is. Brighter particles fit the images better.</source>
        <translation>Puntos: partículas. Cada una es una suposición de dónde está el objetivo. Las más claras encajan mejor con las imágenes.</translation>
    </message>
    <message>
        <source>Tinted and outlined: regions with the color of the target (View › Show mask).</source>
        <translation>Teñido y contorneado: zonas con el color del objetivo (Ver › Mostrar máscara).</translation>
    </message>
    <message>
        <source>Dashed ellipse: the size of the target itself, if the target is not a ball.</source>
        <translation>Elipse discontinua: el tamaño del propio objetivo, si el objetivo no es una pelota.</translation>
    </message>
    <message>
        <source>Box in a corner: the particles, enlarged, if they are too close together to be seen in the view. A line shows where they are, and the bar shows the scale.</source>
        <translation>Recuadro en una esquina: las partículas ampliadas, si están demasiado juntas para verse en la vista. Una línea muestra dónde están, y la barra muestra la escala.</translation>
    </message>
    <message>
        <source>Dark band along a path in the bird&apos;s-eye view: the time range that is selected in the timeline. Press Esc in the timeline to remove the selection.</source>
        <translation>Banda oscura a lo largo de una trayectoria en la vista de pájaro: el intervalo de tiempo seleccionado en la línea de tiempo. Pulse Esc en la línea de tiempo para quitar la selección.</translation>
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
        <source>Drag the grid in %1</source>
        <translation>Arrastrar la cuadrícula en %1</translation>
    </message>
    <message>
        <source>Cannot move further: a grid point would leave the camera&apos;s field of view</source>
        <translation>No se puede mover más: un punto de la cuadrícula saldría del campo de visión de la cámara</translation>
    </message>
    <message>
        <source>Cannot move further: this grid point and the held grid points lie on one line</source>
        <translation>No se puede mover más: este punto de la cuadrícula y los puntos sujetos están en una misma recta</translation>
    </message>
    <message>
        <source>Cannot move further: no nearby camera pose keeps the held grid points in place</source>
        <translation>No se puede mover más: ninguna pose cercana de la cámara mantiene en su sitio los puntos sujetos de la cuadrícula</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>adelante</translation>
    </message>
    <message>
        <source>up</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>cabeceo</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>alabeo</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>guiñada</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>%1: change focal length by %2 %</source>
        <translation>%1: cambiar la distancia focal un %2 %</translation>
    </message>
    <message>
        <source>At most three grid points can be held in place. To release one, click it</source>
        <translation>Se pueden fijar como máximo tres puntos de la cuadrícula. Para soltar uno, haga clic en él</translation>
    </message>
    <message>
        <source>Three held points fix the pose. Release one of them, or turn on “Also fit the focal length when three points are held”</source>
        <translation>Tres puntos sujetos fijan la pose. Suelte uno de ellos, o active «Con tres puntos sujetos, ajustar la distancia focal»</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibrationPage</name>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Reference grid</source>
        <translation>Cuadrícula de referencia</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Puntos medidos</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>A mano</translation>
    </message>
    <message>
        <source>Drag the grid in an image until it matches the real scene. Click a grid point to hold it in place. Turn the wheel to zoom; double-click beside the grid points to see the whole image.</source>
        <translation>Arrastre la cuadrícula en una imagen hasta que coincida con la escena real. Un clic en un punto de la cuadrícula lo sujeta. Gire la rueda para ampliar; un doble clic lejos de los puntos de la cuadrícula muestra la imagen entera.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualWindow</name>
    <message>
        <source>Manual – Dewpoint</source>
        <translation>Manual – Dewpoint</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Páginas del manual</translation>
    </message>
    <message>
        <source>Go back to the previous page</source>
        <translation>Volver a la página anterior</translation>
    </message>
    <message>
        <source>Go forward one page</source>
        <translation>Avanzar a la página siguiente</translation>
    </message>
    <message>
        <source>The manual was not found. It is expected in the folder %1.</source>
        <translation>No se encontró el manual. Debería estar en la carpeta %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MarkerEditor</name>
    <message>
        <source>Name of the marker</source>
        <translation>Nombre de la marca</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>Marca %1</translation>
    </message>
    <message>
        <source>Add a marker</source>
        <translation>Añadir una marca</translation>
    </message>
    <message>
        <source>Remove a marker</source>
        <translation>Quitar una marca</translation>
    </message>
    <message>
        <source>Rename a marker</source>
        <translation>Renombrar una marca</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageHistory</name>
    <message>
        <source>Messages – Dewpoint</source>
        <translation>Mensajes – Dewpoint</translation>
    </message>
    <message>
        <source>Messages, the newest last</source>
        <translation>Mensajes, el más reciente al final</translation>
    </message>
    <message>
        <source>There have been no messages yet.</source>
        <translation>Todavía no ha habido mensajes.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy all messages as text</source>
        <translation>Copiar todos los mensajes como texto</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageRow</name>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MissingFilesOffer</name>
    <message>
        <source>%1 was not found in %2.</source>
        <translation>No se encontró %1 en %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n files of this project were not found: %1.</source>
        <translation>
            <numerusform>No se encontró %n archivo de este proyecto: %1.</numerusform>
            <numerusform>No se encontraron %n archivos de este proyecto: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>Buscar…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>Buscar %1</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The project was opened with the files that you located. Save the project to keep their new paths.</source>
        <translation>El proyecto se abrió con los archivos que localizó. Guarde el proyecto para conservar sus nuevas rutas.</translation>
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
        <translation>Proyecto nuevo</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>Archivos de vídeo, uno por cámara</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>Una carpeta de imágenes, una por fotograma</translation>
    </message>
    <message>
        <source>All cameras connected to this computer</source>
        <translation>Todas las cámaras conectadas a este equipo</translation>
    </message>
    <message>
        <source>Enter a device number or a network stream</source>
        <translation>Introduzca un número de dispositivo o un flujo de red</translation>
    </message>
    <message>
        <source>Remove the selected cameras</source>
        <translation>Quitar las cámaras elegidas</translation>
    </message>
    <message>
        <source>Create the project and show its first images</source>
        <translation>Crear el proyecto y mostrar sus primeras imágenes</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Go back without creating a project</source>
        <translation>Volver sin crear un proyecto</translation>
    </message>
    <message>
        <source>Name of the project</source>
        <translation>Nombre del proyecto</translation>
    </message>
    <message>
        <source>Frame rate of image folders, 0.1 to 10,000 per second</source>
        <translation>Frecuencia de las carpetas de imágenes, de 0,1 a 10 000 por segundo</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Images from</source>
        <translation>Imágenes de</translation>
    </message>
    <message>
        <source>Cameras in the new project</source>
        <translation>Cámaras del proyecto nuevo</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>Elija un vídeo por cámara</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>Vídeos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Elija una carpeta de imágenes</translation>
    </message>
    <message>
        <source>No camera is connected to this computer. A network camera can be added by its address.</source>
        <translation>No hay ninguna cámara conectada a este equipo. Una cámara de red se puede añadir por su dirección.</translation>
    </message>
    <message>
        <source>The calibration uses other camera names. The cameras were matched by order.</source>
        <translation>La calibración usa otros nombres de cámara. Las cámaras se asignaron por orden.</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>Añadir vídeos…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>Añadir carpeta de imágenes…</translation>
    </message>
    <message>
        <source>Add connected cameras</source>
        <translation>Añadir cámaras conectadas</translation>
    </message>
    <message>
        <source>Add address</source>
        <translation>Añadir dirección</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Crear</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>Images per second:</source>
        <translation>Imágenes por segundo:</translation>
    </message>
    <message>
        <source>Not a video, image or calibration file: %1.</source>
        <translation>No es un archivo de vídeo, de imagen ni de calibración: %1.</translation>
    </message>
    <message>
        <source>One row per camera. The videos must be synchronized: frame N must show the same time in all of them.</source>
        <translation>Una fila por cámara. Los vídeos deben estar sincronizados: el fotograma N debe mostrar el mismo instante en todos.</translation>
    </message>
    <message>
        <source>(folder name)</source>
        <translation>(nombre de la carpeta)</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontrado</translation>
    </message>
    <message>
        <source>%1. Create the project without this file, then choose Calibration › Import calibration.</source>
        <translation>%1. Cree el proyecto sin este archivo y elija después Calibración › Importar calibración.</translation>
    </message>
    <message>
        <source>Probably a mistake in the calibration: %1</source>
        <translation>Probablemente un error en la calibración: %1</translation>
    </message>
    <message>
        <source>%1. Choose below how the images differ from those of the calibration.</source>
        <translation>%1. Elija abajo en qué se diferencian las imágenes de las de la calibración.</translation>
    </message>
    <message>
        <source>%1. For each camera of the project, choose a camera of the file below.</source>
        <translation>%1. Para cada cámara del proyecto, elija abajo una cámara del archivo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::NoticeList</name>
    <message>
        <source>Hide these notices. The status bar shows how many are hidden</source>
        <translation>Ocultar estos avisos. La barra de estado muestra cuántos están ocultos</translation>
    </message>
    <message numerus="yes">
        <source>and %n more notice(s)</source>
        <translation>
            <numerusform>y %n aviso más</numerusform>
            <numerusform>y %n avisos más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OldResultsOffer</name>
    <message>
        <source>Track again</source>
        <translation>Seguir de nuevo</translation>
    </message>
    <message>
        <source>Some frames were tracked with earlier settings.</source>
        <translation>Algunos fotogramas se siguieron con ajustes anteriores.</translation>
    </message>
    <message>
        <source>Tracking began at frame %1, where you clicked. The frames before it are not tracked.</source>
        <translation>El seguimiento comenzó en el fotograma %1, donde hizo clic. Los fotogramas anteriores no se han seguido.</translation>
    </message>
    <message>
        <source>Track from the first frame</source>
        <translation>Seguir desde el primer fotograma</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OutputController</name>
    <message>
        <source>%1: %2 sent, %3 dropped</source>
        <translation>%1: %2 enviados, %3 descartados</translation>
    </message>
    <message numerus="yes">
        <source>Sending, %n program(s) connected</source>
        <translation>
            <numerusform>Enviando, %n programa conectado</numerusform>
            <numerusform>Enviando, %n programas conectados</numerusform>
        </translation>
    </message>
    <message>
        <source>Sending</source>
        <translation>Enviando</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OutputDialog</name>
    <message>
        <source>Change outputs</source>
        <translation>Cambiar las salidas</translation>
    </message>
    <message>
        <source>Outputs – Dewpoint</source>
        <translation>Salidas – Dewpoint</translation>
    </message>
    <message>
        <source>Choose where results are sent during a run. Nothing is sent before you choose Run › Send results.</source>
        <translation>Elija adónde se envían los resultados durante una ejecución. No se envía nada hasta que elija Ejecución › Enviar resultados.</translation>
    </message>
    <message>
        <source>TCP port for JSON lines</source>
        <translation>Puerto TCP para líneas JSON</translation>
    </message>
    <message>
        <source>Programs that connect to this port get one line of JSON for each frame</source>
        <translation>Los programas que se conectan a este puerto reciben una línea JSON por fotograma</translation>
    </message>
    <message>
        <source>TCP port</source>
        <translation>Puerto TCP</translation>
    </message>
    <message>
        <source>Port for WebSocket and web page</source>
        <translation>Puerto para WebSocket y página web</translation>
    </message>
    <message>
        <source>Port of a web page that shows the targets in a browser. At the same port, programs get the results through a WebSocket</source>
        <translation>Puerto de una página web que muestra los objetivos en un navegador. En el mismo puerto, los programas reciben los resultados por un WebSocket</translation>
    </message>
    <message>
        <source>WebSocket port</source>
        <translation>Puerto WebSocket</translation>
    </message>
    <message>
        <source>OSC to</source>
        <translation>OSC a</translation>
    </message>
    <message>
        <source>Computer and UDP port that OSC messages are sent to, such as 127.0.0.1:9000. Empty: off</source>
        <translation>Equipo y puerto UDP a los que se envían mensajes OSC, por ejemplo 127.0.0.1:9000. Vacío: desactivado</translation>
    </message>
    <message>
        <source>TUIO to</source>
        <translation>TUIO a</translation>
    </message>
    <message>
        <source>Computer and UDP port that TUIO 1.1 3D cursors are sent to, such as 127.0.0.1:3333. Empty: off</source>
        <translation>Equipo y puerto UDP a los que se envían cursores 3D de TUIO 1.1, por ejemplo 127.0.0.1:3333. Vacío: desactivado</translation>
    </message>
    <message>
        <source>CSV file</source>
        <translation>Archivo CSV</translation>
    </message>
    <message>
        <source>File or named pipe that gets one line for each target and frame. Empty: off</source>
        <translation>Archivo o tubería con nombre que recibe una línea por objetivo y fotograma. Vacío: desactivado</translation>
    </message>
    <message>
        <source>Who can connect</source>
        <translation>Quién puede conectarse</translation>
    </message>
    <message>
        <source>Which computers can connect to the ports. If you allow all computers, anyone in the network can see the results</source>
        <translation>Qué equipos pueden conectarse a los puertos. Si permite todos los equipos, cualquiera en la red puede ver los resultados</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Axes of the positions that are sent</source>
        <translation>Ejes de las posiciones que se envían</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Unit of the positions that are sent</source>
        <translation>Unidad de las posiciones que se envían</translation>
    </message>
    <message>
        <source>Max. frames per second</source>
        <translation>Máx. de fotogramas por segundo</translation>
    </message>
    <message>
        <source>Largest number of frames per second that are sent. 0: all frames</source>
        <translation>Mayor número de fotogramas por segundo que se envían. 0: todos</translation>
    </message>
    <message>
        <source>Token for remote commands</source>
        <translation>Testigo para órdenes remotas</translation>
    </message>
    <message>
        <source>Programs that send this word can start and stop the run and the recording of the cameras. At least %1 characters. Empty: commands are ignored</source>
        <translation>Los programas que envían esta palabra pueden iniciar y detener la ejecución y la grabación de las cámaras. Al menos %1 caracteres. Vacío: se ignoran las órdenes</translation>
    </message>
    <message>
        <source>this computer only</source>
        <translation>solo este equipo</translation>
    </message>
    <message>
        <source>all computers in the network</source>
        <translation>todos los equipos de la red</translation>
    </message>
    <message>
        <source>z up, right-handed (as in Dewpoint)</source>
        <translation>z hacia arriba, mano derecha (como en Dewpoint)</translation>
    </message>
    <message>
        <source>y up, right-handed</source>
        <translation>y hacia arriba, mano derecha</translation>
    </message>
    <message>
        <source>y up, left-handed (as in Unity)</source>
        <translation>y hacia arriba, mano izquierda (como en Unity)</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OverlayLegend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>Leyenda de los signos</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ParameterPanel</name>
    <message>
        <source>The parameters appear here once a project is open.</source>
        <translation>Los parámetros aparecen aquí en cuanto se abre un proyecto.</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Método</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>Haga clic en el objeto o dibuje un recuadro a su alrededor en cualquier cámara.</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>This value is larger than “%1”, so %2 is used instead.</source>
        <translation>Este valor es mayor que «%1», así que en su lugar se usa %2.</translation>
    </message>
    <message>
        <source>Tracking method. Changing it restarts tracking; other settings are kept.</source>
        <translation>Método de seguimiento. Al cambiarlo, el seguimiento se reinicia; los demás ajustes se conservan.</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>Reset all parameters of this method to their defaults</source>
        <translation>Devolver todos los parámetros de este método a sus valores por defecto</translation>
    </message>
    <message>
        <source>Volume of interest</source>
        <translation>Volumen de interés</translation>
    </message>
    <message>
        <source>Targets are searched for only inside a box.</source>
        <translation>Los objetivos se buscan solo en una caja.</translation>
    </message>
    <message>
        <source>Some values in this group differ from their defaults.</source>
        <translation>Algunos valores aquí difieren de sus valores por defecto.</translation>
    </message>
    <message>
        <source>This value is smaller than “%1”, so “%1” has no effect.</source>
        <translation>Este valor es menor que «%1», así que «%1» no tiene efecto.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeopleDock</name>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Click a person in a camera image, or the floor in the bird&apos;s-eye view. Press Esc to cancel.</source>
        <translation>Haga clic en una persona en una imagen de cámara, o en el suelo en la vista de pájaro. Pulse Esc para cancelar.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Añadir una persona</translation>
    </message>
    <message>
        <source>Remove a person</source>
        <translation>Quitar una persona</translation>
    </message>
    <message>
        <source>Folder for the 3D shapes of people</source>
        <translation>Carpeta para las formas 3D de las personas</translation>
    </message>
    <message>
        <source>%1 already contains files of an earlier export. Replace them?</source>
        <translation>%1 ya contiene archivos de una exportación anterior. ¿Reemplazarlos?</translation>
    </message>
    <message>
        <source>The run has ended, so the 3D shapes of people were not saved.</source>
        <translation>La ejecución ha terminado, así que las formas 3D de las personas no se guardaron.</translation>
    </message>
    <message>
        <source>Saving the 3D shapes of people…</source>
        <translation>Guardando las formas 3D de las personas…</translation>
    </message>
    <message>
        <source>Saved the positions, volumes, hulls and densities of the people in %1 (frames: %2).</source>
        <translation>Las posiciones, volúmenes, envolventes y densidades de las personas se guardaron en %1 (fotogramas: %2).</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeoplePanel</name>
    <message>
        <source>People in view</source>
        <translation>Personas presentes</translation>
    </message>
    <message>
        <source>Progress of learning the background</source>
        <translation>Progreso del aprendizaje del fondo</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Position on the floor, x and y in meters</source>
        <translation>Posición en el suelo, x e y en metros</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Estatura</translation>
    </message>
    <message>
        <source>Estimated height in meters; empty if the method does not estimate it</source>
        <translation>Estatura estimada en metros; vacío si el método no la estima</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Speed over the floor, in meters per second</source>
        <translation>Velocidad sobre el suelo, en metros por segundo</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Number of cameras that see the person, out of all cameras</source>
        <translation>Número de cámaras que ven a la persona, del total</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Time since the person entered, in seconds</source>
        <translation>Tiempo desde que entró la persona, en segundos</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Learning the background: %1 %. Keep the scene empty.</source>
        <translation>Aprendiendo el fondo: %1 %. No entre en la imagen.</translation>
    </message>
    <message>
        <source>Nobody is in view. People appear when two cameras see them.</source>
        <translation>No hay nadie a la vista. Las personas aparecen cuando las ven dos cámaras.</translation>
    </message>
    <message>
        <source>People in view: %1</source>
        <translation>Personas presentes: %1</translation>
    </message>
    <message>
        <source>People appear here once a method for people runs.</source>
        <translation>Las personas aparecen aquí cuando se ejecuta un método para personas.</translation>
    </message>
    <message>
        <source>Another person is close</source>
        <translation>Hay otra persona cerca</translation>
    </message>
    <message>
        <source>Number of the person. No other person gets the same number in this run</source>
        <translation>Número de la persona. Ninguna otra persona recibe el mismo número en esta ejecución</translation>
    </message>
    <message>
        <source>Volume of the hull that encloses 95 % of the person, in cubic meters. Empty unless “Show 3D shapes of people” is on</source>
        <translation>Volumen de la envolvente que encierra el 95 % de la persona, en metros cúbicos. Vacío mientras «Mostrar formas 3D de las personas» esté desactivado</translation>
    </message>
    <message>
        <source>● means that another person is close. Until the two are apart again, the method learns nothing new about the colors of this person</source>
        <translation>● significa que hay otra persona cerca. Hasta que se separen, el método no aprende nada nuevo sobre los colores de esta persona</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlanPage</name>
    <message>
        <source>See how accurately these cameras will measure, and where another camera would help. Drag a camera in the bird&apos;s-eye view to update the map.</source>
        <translation>Vea con qué precisión medirán estas cámaras y dónde ayudaría otra cámara. Arrastre una cámara en la vista de pájaro y el mapa se actualiza.</translation>
    </message>
    <message>
        <source>Map of expected errors</source>
        <translation>Mapa de errores esperados</translation>
    </message>
    <message>
        <source>Planned cameras</source>
        <translation>Cámaras planeadas</translation>
    </message>
    <message>
        <source>Planned cameras are not saved with the project and take no part in the run. The map does not account for objects that block the view.</source>
        <translation>Las cámaras planeadas no se guardan con el proyecto ni forman parte de la ejecución. El mapa no tiene en cuenta objetos que tapen la vista.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planificar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerForm</name>
    <message>
        <source>Add planned camera</source>
        <translation>Añadir cámara planeada</translation>
    </message>
    <message>
        <source>Add a planned camera; you can then drag it in the bird&apos;s-eye view, or enter its position (%1)</source>
        <translation>Añadir una cámara planeada; después puede arrastrarla en la vista de pájaro o introducir su posición (%1)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the planned camera</source>
        <translation>Quitar la cámara planeada</translation>
    </message>
    <message>
        <source>Remove the selected planned camera</source>
        <translation>Quitar la cámara planeada seleccionada</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>Cámara planeada</translation>
    </message>
    <message>
        <source>Position x, y, z</source>
        <translation>Posición x, y, z</translation>
    </message>
    <message>
        <source>Looks at x, y, z</source>
        <translation>Mira a x, y, z</translation>
    </message>
    <message>
        <source>Field of view, image width and height</source>
        <translation>Campo de visión, anchura y altura de la imagen</translation>
    </message>
    <message>
        <source>Planned position (%1 coordinate)</source>
        <translation>Posición planeada (coordenada %1)</translation>
    </message>
    <message>
        <source>Position of the camera, in meters</source>
        <translation>Posición de la cámara, en metros</translation>
    </message>
    <message>
        <source>Planned camera looks at (%1 coordinate)</source>
        <translation>La cámara planeada mira a (coordenada %1)</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Campo de visión</translation>
    </message>
    <message>
        <source>Horizontal field of view of the camera</source>
        <translation>Campo de visión horizontal de la cámara</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>Anchura de la imagen</translation>
    </message>
    <message>
        <source>Image height</source>
        <translation>Altura de la imagen</translation>
    </message>
    <message>
        <source>The search places the camera on four walls and a ceiling at this distance from the volume</source>
        <translation>La búsqueda coloca la cámara en cuatro paredes y un techo a esta distancia del volumen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Cancelar la búsqueda</translation>
    </message>
    <message>
        <source>Stop the search without adding a camera</source>
        <translation>Terminar la búsqueda sin añadir una cámara</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aún ninguna</translation>
    </message>
    <message>
        <source>none selected</source>
        <translation>ninguna elegida</translation>
    </message>
    <message>
        <source>Find best position for %1</source>
        <translation>Buscar la mejor posición para %1</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the position where another camera would help most (%1)</source>
        <translation>Buscar en paredes y techo la posición donde más ayudaría otra cámara (%1)</translation>
    </message>
    <message>
        <source>Choose the planned camera whose values are shown below</source>
        <translation>Elija la cámara planeada cuyos valores se muestran abajo</translation>
    </message>
    <message>
        <source>A point that the planned camera looks at, in meters</source>
        <translation>Un punto al que mira la cámara planeada, en metros</translation>
    </message>
    <message>
        <source>Width of the planned camera&apos;s image, in pixels</source>
        <translation>Anchura de la imagen de la cámara planeada, en píxeles</translation>
    </message>
    <message>
        <source>Height of the planned camera&apos;s image, in pixels</source>
        <translation>Altura de la imagen de la cámara planeada, en píxeles</translation>
    </message>
    <message>
        <source>Distance to walls and ceiling</source>
        <translation>Distancia a las paredes y el techo</translation>
    </message>
    <message>
        <source>Distance from the volume to the walls and the ceiling</source>
        <translation>Distancia del volumen a las paredes y al techo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerInstaller</name>
    <message>
        <source>Move %1 in the bird&apos;s-eye view</source>
        <translation>Mover %1 en la vista de pájaro</translation>
    </message>
    <message>
        <source>Turn %1 in the bird&apos;s-eye view</source>
        <translation>Girar %1 en la vista de pájaro</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotPanel</name>
    <message>
        <source>Plots of the run</source>
        <translation>Gráficos de la ejecución</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Choose which plots to show; copy or save plots</source>
        <translation>Elegir los gráficos mostrados; copiarlos o guardarlos</translation>
    </message>
    <message>
        <source>Choose which plots to show</source>
        <translation>Elegir qué gráficos se muestran</translation>
    </message>
    <message>
        <source>The plots are on the clipboard as CSV.</source>
        <translation>Los gráficos están en el portapapeles como CSV.</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>Guardar los gráficos</translation>
    </message>
    <message>
        <source>Drawings (*.svg);;Pictures (*.png)</source>
        <translation>Dibujos (*.svg);;Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>No se pudo escribir %1.</translation>
    </message>
    <message>
        <source>Plots appear during tracking.</source>
        <translation>Los gráficos aparecen durante el seguimiento.</translation>
    </message>
    <message>
        <source>The target whose values are plotted: the target selected in the panel Target, or the first target if none is selected.</source>
        <translation>El objetivo cuyos valores se representan: el elegido en el panel Objetivo, o el primero si no hay ninguno elegido.</translation>
    </message>
    <message>
        <source>The frame that all views show. The numbers beside the plots are the values in this frame.
In the plots, the wheel scrolls, Ctrl+wheel zooms in time at the pointer, and Shift+wheel moves along the time axis.</source>
        <translation>El fotograma que muestran todas las vistas. Los números junto a los gráficos son los valores en este fotograma.
En los gráficos, la rueda desplaza, Ctrl+rueda amplía el tiempo en el puntero y Mayús+rueda recorre el eje del tiempo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotStack</name>
    <message>
        <source>frame %1, iteration %2, %3</source>
        <translation>fotograma %1, iteración %2, %3</translation>
    </message>
    <message>
        <source>Click: go to this frame · Ctrl+wheel: zoom</source>
        <translation>Clic: ir a este fotograma · Ctrl+rueda: zoom</translation>
    </message>
    <message>
        <source>frame %1, %2</source>
        <translation>fotograma %1, %2</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointCalibrator</name>
    <message>
        <source>point %1</source>
        <translation>punto %1</translation>
    </message>
    <message>
        <source>Add measured point</source>
        <translation>Añadir punto medido</translation>
    </message>
    <message>
        <source>Remove measured point</source>
        <translation>Quitar punto medido</translation>
    </message>
    <message>
        <source>Rename measured point</source>
        <translation>Renombrar punto medido</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Posición de %1</translation>
    </message>
    <message>
        <source>Click %1 in %2</source>
        <translation>Marcar %1 en %2</translation>
    </message>
    <message>
        <source>Remove %1 in %2</source>
        <translation>Quitar %1 en %2</translation>
    </message>
    <message>
        <source>Compute cameras from measured points</source>
        <translation>Calcular las cámaras con los puntos medidos</translation>
    </message>
    <message>
        <source>%1: average error %2</source>
        <translation>%1: error medio %2</translation>
    </message>
    <message>
        <source>%1: no pose fits the clicked points</source>
        <translation>%1: ninguna pose encaja con los puntos marcados</translation>
    </message>
    <message>
        <source>%1 (ignore this if the camera is mounted that way)</source>
        <translation>%1 (ignore esto si la cámara está montada así)</translation>
    </message>
    <message>
        <source>%1. After this correction, the average error is %2</source>
        <translation>%1. Una vez corregido, el error medio es de %2</translation>
    </message>
    <message>
        <source>%1 does not fit the other points (%2, %3): measure or click it again</source>
        <translation>%1 no encaja con los demás puntos (%2, %3): mídalo o márquelo otra vez</translation>
    </message>
    <message>
        <source>Largest error: %1 (%2, %3)</source>
        <translation>Mayor error: %1 (%2, %3)</translation>
    </message>
    <message>
        <source>Set orientation of %1</source>
        <translation>Fijar la orientación de %1</translation>
    </message>
    <message>
        <source>The images of %1 are rotated and mirrored: turn them clockwise by %2 degrees, then mirror them</source>
        <translation>Las imágenes de %1 están giradas y reflejadas: gírelas %2 grados en sentido horario y después refléjelas</translation>
    </message>
    <message>
        <source>The images of %1 are mirrored</source>
        <translation>Las imágenes de %1 están reflejadas</translation>
    </message>
    <message>
        <source>The images of %1 are rotated: turn them clockwise by %2 degrees</source>
        <translation>Las imágenes de %1 están giradas: gírelas %2 grados en sentido horario</translation>
    </message>
    <message>
        <source>%1: the focal length was kept, because computing it needs at least %2 points</source>
        <translation>%1: se conservó la distancia focal, porque para calcularla se necesitan al menos %2 puntos</translation>
    </message>
    <message>
        <source>No point has been clicked yet. Press “Click in images”, then click the selected point in the images</source>
        <translation>Aún no ha marcado ningún punto. Pulse «Marcar en imágenes» y haga clic en el punto elegido en las imágenes</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n point(s) clicked, but at least %2 are needed (six are better)</source>
        <translation>
            <numerusform>%1: %n punto marcado, pero se necesitan al menos %2 (mejor seis)</numerusform>
            <numerusform>%1: %n puntos marcados, pero se necesitan al menos %2 (mejor seis)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: all points lie on one line. Add a point away from this line</source>
        <translation>%1: todos los puntos están en una recta. Añada un punto fuera de ella</translation>
    </message>
    <message>
        <source>%1: average error %2, but a second pose fits equally well. Add a point outside the plane of the others</source>
        <translation>%1: error medio %2, pero otra pose encaja igual. Añada un punto fuera del plano de los demás</translation>
    </message>
    <message>
        <source>Mirror the images of %1</source>
        <translation>Reflejar las imágenes de %1</translation>
    </message>
    <message>
        <source>Rotate the images of %1 clockwise by %2, and mirror them</source>
        <translation>Girar las imágenes de %1 %2 en sentido horario y reflejarlas</translation>
    </message>
    <message>
        <source>Rotate the images of %1 clockwise by %2</source>
        <translation>Girar las imágenes de %1 %2 en sentido horario</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointsTable</name>
    <message>
        <source>Measured points</source>
        <translation>Puntos medidos</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
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
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Añadir punto</translation>
    </message>
    <message>
        <source>Add a position that you measured in the room</source>
        <translation>Añadir una posición que haya medido en la sala</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Quitar punto</translation>
    </message>
    <message>
        <source>Click in images</source>
        <translation>Marcar en imágenes</translation>
    </message>
    <message>
        <source>Remove click</source>
        <translation>Quitar clic</translation>
    </message>
    <message>
        <source>Compute focal lengths</source>
        <translation>Calcular distancias focales</translation>
    </message>
    <message>
        <source>Compute cameras</source>
        <translation>Calcular cámaras</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>Rotate or mirror the images of this camera and compute its pose again</source>
        <translation>Girar o reflejar las imágenes de esta cámara y calcular de nuevo su pose</translation>
    </message>
    <message>
        <source>Click the selected point in every image that shows it. Near a corner, the click moves exactly onto the corner; hold Alt to prevent this. Press Esc to finish.</source>
        <translation>Haga clic en el punto elegido en cada imagen que lo muestre. Cerca de una esquina, el clic se mueve justo a la esquina; mantenga pulsada Alt para evitarlo. Pulse Esc para terminar.</translation>
    </message>
    <message>
        <source>Remove the click on the selected point from the image of the selected camera</source>
        <translation>Quitar el clic en el punto elegido de la imagen de la cámara elegida</translation>
    </message>
    <message>
        <source>clicked</source>
        <translation>clics</translation>
    </message>
    <message>
        <source>Remove the selected point</source>
        <translation>Quitar el punto seleccionado</translation>
    </message>
    <message>
        <source>Also compute the focal length of each camera in which you clicked six or more points. Other cameras keep their focal length</source>
        <translation>Calcular también la distancia focal de cada cámara en la que hizo clic en seis puntos o más. Las demás cámaras conservan su distancia focal</translation>
    </message>
    <message>
        <source>Compute the poses of all cameras in which points were clicked. Each camera needs at least four points; six that do not all lie in one plane are better</source>
        <translation>Calcular las poses de todas las cámaras en las que se marcaron puntos. Cada cámara necesita al menos cuatro puntos; mejor seis que no estén todos en un plano</translation>
    </message>
    <message>
        <source>Positions measured with a tape, in meters: double-click to edit. ▲ marks a point that does not fit the others.</source>
        <translation>Posiciones medidas con cinta, en metros: doble clic para editar. ▲ indica un punto que no encaja con los demás.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PreviewPane</name>
    <message>
        <source>Preparing the preview: %1 %</source>
        <translation>Preparando la vista previa: %1 %</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>Primeras líneas del archivo</translation>
    </message>
    <message>
        <source>Units and axes</source>
        <translation>Unidades y ejes</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Some of these results were tracked with earlier settings.</source>
        <translation>Algunos de estos resultados se obtuvieron con ajustes anteriores.</translation>
    </message>
    <message>
        <source>The preview was stopped. It starts again when you change a setting.</source>
        <translation>La vista previa se detuvo. Empieza de nuevo cuando cambie un ajuste.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProblemReport</name>
    <message>
        <source>Report a problem – Dewpoint</source>
        <translation>Informar de un problema – Dewpoint</translation>
    </message>
    <message>
        <source>Text for the report</source>
        <translation>Texto para el informe</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the text so that you can paste it into an email or a form</source>
        <translation>Copiar el texto, para pegarlo en un correo o un formulario</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Run self-test</source>
        <translation>Ejecutar autoprueba</translation>
    </message>
    <message>
        <source>Stop the self-test</source>
        <translation>Detener la autoprueba</translation>
    </message>
    <message>
        <source>Test graphics, codecs, cameras and disk, and track a simulated scene for a few seconds</source>
        <translation>Probar gráficos, códecs, cámaras y disco, y seguir una escena simulada durante unos segundos</translation>
    </message>
    <message>
        <source>Write to whoever gave you Dewpoint. Describe what you did, what you expected and what happened. Run the self-test. Attach the text below and, if you can, the project file and a screenshot. Nothing is sent automatically.</source>
        <translation>Escriba a quien le dio Dewpoint. Describa qué hizo, qué esperaba y qué ocurrió. Ejecute la autoprueba. Adjunte el texto de abajo y, si puede, el archivo del proyecto y una captura de pantalla. Nada se envía automáticamente.</translation>
    </message>
    <message>
        <source>Progress of the self-test</source>
        <translation>Progreso de la autoprueba</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectCheckDialog</name>
    <message>
        <source>Checking recordings, times, calibration, colors and method…</source>
        <translation>Comprobando grabaciones, tiempos, calibración, colores y método…</translation>
    </message>
    <message>
        <source>The check was canceled.</source>
        <translation>La comprobación se canceló.</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) must be solved before this project can be tracked.</source>
        <translation>
            <numerusform>Para hacer el seguimiento con este proyecto hay que resolver %n problema.</numerusform>
            <numerusform>Para hacer el seguimiento con este proyecto hay que resolver %n problemas.</numerusform>
        </translation>
    </message>
    <message>
        <source>No problems, but look at the points marked ◆.</source>
        <translation>No hay problemas. Puede que los puntos marcados con ◆ no sean lo que desea.</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>No hay problemas.</translation>
    </message>
    <message>
        <source>Check project – Dewpoint</source>
        <translation>Comprobar el proyecto – Dewpoint</translation>
    </message>
    <message>
        <source>Result of the check</source>
        <translation>Resultado de la comprobación</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Progreso de la comprobación</translation>
    </message>
    <message>
        <source>Read every frame</source>
        <translation>Leer todos los fotogramas</translation>
    </message>
    <message>
        <source>Find damaged frames anywhere in a recording: all frames are read, not only a few of them. This takes longer</source>
        <translation>Encontrar fotogramas dañados en cualquier parte de una grabación: se leen todos los fotogramas, no solo algunos. Tarda más</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Comprobar de nuevo</translation>
    </message>
    <message>
        <source>Check the project as it is now</source>
        <translation>Comprobar el proyecto tal como está ahora</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>Detener la comprobación</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the result as English text, for example for a bug report</source>
        <translation>Copiar el resultado como texto en inglés, por ejemplo para informar de un error</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectController</name>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>Haga clic en el objeto o dibuje un recuadro a su alrededor en cualquier cámara.</translation>
    </message>
    <message>
        <source>Click the object to track in any image. Its color is learned and tracking starts.</source>
        <translation>Haga clic en cualquier imagen en el objeto que quiere seguir. Se aprende su color y empieza el seguimiento.</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Abrir un proyecto</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml);;All files (*)</source>
        <translation>Proyectos de Dewpoint (*.toml);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The changes were recovered. Save the project to keep them.</source>
        <translation>Los cambios se recuperaron. Guarde el proyecto para conservarlos.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectPane</name>
    <message>
        <source>Cameras of the project</source>
        <translation>Cámaras del proyecto</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Exchange with</source>
        <translation>Intercambiar con</translation>
    </message>
    <message>
        <source>Exchange the image source with that of another camera, for example after the cables were exchanged. The cameras keep their names and calibrations</source>
        <translation>Intercambiar la fuente de imágenes con la de otra cámara, por ejemplo si se intercambiaron los cables. Las cámaras conservan sus nombres y calibraciones</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>Nombre de la cámara, en vistas y archivos</translation>
    </message>
    <message>
        <source>Rotated</source>
        <translation>Girada</translation>
    </message>
    <message>
        <source>Clockwise rotation of the images before use. The calibration is rotated with them</source>
        <translation>Giro de las imágenes en sentido horario antes de usarlas. La calibración gira con ellas</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Reflejada</translation>
    </message>
    <message>
        <source>Mirror the images left to right, after rotation</source>
        <translation>Reflejar las imágenes de izquierda a derecha, tras girarlas</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>Fijar colores</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of this camera, and keep the current values</source>
        <translation>Desactivar la exposición, la ganancia y el balance de blancos automáticos de esta cámara y conservar los valores actuales</translation>
    </message>
    <message>
        <source>Lock all cameras</source>
        <translation>Fijar todas las cámaras</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of all connected cameras, and keep the current values</source>
        <translation>Desactivar la exposición, la ganancia y el balance de blancos automáticos de todas las cámaras conectadas y conservar los valores actuales</translation>
    </message>
    <message>
        <source>Remove this camera. Undo restores it with its calibration</source>
        <translation>Quitar esta cámara. Deshacer la restaura con su calibración</translation>
    </message>
    <message>
        <source>A project needs at least one camera</source>
        <translation>Un proyecto necesita al menos una cámara</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulada</translation>
    </message>
    <message>
        <source>A simulated scene has its own cameras. They cannot be changed.</source>
        <translation>Una escena simulada tiene sus propias cámaras. No se pueden cambiar.</translation>
    </message>
    <message>
        <source>▲ Several devices may be this camera. Choose one on the right.</source>
        <translation>▲ Varios dispositivos pueden ser esta cámara. Elija uno a la derecha.</translation>
    </message>
    <message>
        <source>▲ This device is not connected.</source>
        <translation>▲ Este dispositivo no está conectado.</translation>
    </message>
    <message>
        <source>This camera is not calibrated yet.</source>
        <translation>Esta cámara todavía no está calibrada.</translation>
    </message>
    <message>
        <source>▲ The calibration is for images of %1. Choose this size, or calibrate again.</source>
        <translation>▲ La calibración es para imágenes de %1. Elija este tamaño o calibre de nuevo.</translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>Recortada</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::QuickStart</name>
    <message>
        <source>The cameras confirm where the target is.</source>
        <translation>Las cámaras confirman dónde está el objetivo.</translation>
    </message>
    <message>
        <source>Another object fits about as well. Press X and drag the target to its true position.</source>
        <translation>Otro objeto encaja casi igual de bien. Pulse X y arrastre el objetivo a su posición real.</translation>
    </message>
    <message>
        <source>The target is not found yet, or has been out of sight for less than a second.</source>
        <translation>El objetivo aún no se ha encontrado, o no se ve desde hace menos de un segundo.</translation>
    </message>
    <message>
        <source>The target has been out of sight for more than a second. The status bar shows why.</source>
        <translation>El objetivo no se ve desde hace más de un segundo. La barra de estado muestra por qué.</translation>
    </message>
    <message>
        <source>Quick start – Dewpoint</source>
        <translation>Primeros pasos – Dewpoint</translation>
    </message>
    <message>
        <source>What you see</source>
        <translation>Qué se ve</translation>
    </message>
    <message>
        <source>Each camera view shows its image with the estimates drawn over it. The bird&apos;s-eye view shows the estimates in the room.</source>
        <translation>Cada vista de cámara muestra su imagen y, encima, las estimaciones. La vista de pájaro muestra las estimaciones en la sala.</translation>
    </message>
    <message>
        <source>State of a target</source>
        <translation>Estado de un objetivo</translation>
    </message>
    <message>
        <source>How to start</source>
        <translation>Cómo empezar</translation>
    </message>
    <message>
        <source>1.  Open one video per camera, or connect cameras: File › New project (%1). Or try the demo first.</source>
        <translation>1.  Abra un vídeo por cámara o conecte cámaras: Archivo › Proyecto nuevo (%1). O pruebe antes la demo.</translation>
    </message>
    <message>
        <source>3.  Click the object to track in any image. Its color is learned in all cameras, and tracking starts.</source>
        <translation>3.  Haga clic en cualquier imagen en el objeto que quiere seguir. Se aprende su color en todas las cámaras y empieza el seguimiento.</translation>
    </message>
    <message>
        <source>4.  Press %1 to play or pause. Drag along the timeline to look back: all views then show that frame as it was tracked.</source>
        <translation>4.  Pulse %1 para reproducir o pausar. Arrastre por la línea de tiempo para mirar atrás: todas las vistas muestran entonces ese fotograma tal como se siguió.</translation>
    </message>
    <message>
        <source>5.  Export the trajectory: File › Export trajectory (%1).</source>
        <translation>5.  Exporte la trayectoria: Archivo › Exportar la trayectoria (%1).</translation>
    </message>
    <message>
        <source>Show legend…</source>
        <translation>Mostrar leyenda…</translation>
    </message>
    <message>
        <source>Open the legend of everything drawn over the images</source>
        <translation>Abrir la leyenda de todo lo que se dibuja sobre las imágenes</translation>
    </message>
    <message>
        <source>Manual…</source>
        <translation>Manual…</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>Abrir el manual</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
    <message>
        <source>2.  Calibrate the cameras: Calibration › Calibrate (%1) guides you through it. Without a calibration, targets are tracked only in the images.</source>
        <translation>2.  Calibre las cámaras: Calibración › Calibrar (%1) le guía. Sin calibración, los objetivos se siguen solo en las imágenes.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentList</name>
    <message>
        <source>The file no longer exists</source>
        <translation>El archivo ya no existe</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentMenu</name>
    <message>
        <source>No recent projects</source>
        <translation>Ningún proyecto reciente</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>Vaciar la lista</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecoveryOffer</name>
    <message>
        <source>Dewpoint closed unexpectedly. Unsaved changes to “%1” from %2 can be recovered.</source>
        <translation>Dewpoint se cerró inesperadamente. Se pueden recuperar los cambios sin guardar en «%1» de %2.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Unsaved changes to “%1” were discarded.</source>
        <translation>Los cambios sin guardar en «%1» se han descartado.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RigPlanner</name>
    <message>
        <source>With %1 at x %2, y %3, z %4, the error is at most %6 in %5 of the volume (in %7 without this camera).</source>
        <translation>Con %1 en x %2, y %3, z %4, el error es como mucho %6 en el %5 del volumen (en el %7 sin esta cámara).</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RoomDisplay</name>
    <message>
        <source>What to show next – Dewpoint</source>
        <translation>Qué mostrar a continuación – Dewpoint</translation>
    </message>
    <message>
        <source>Time for which the board was held still</source>
        <translation>Tiempo que el tablero se mantuvo quieto</translation>
    </message>
    <message numerus="yes">
        <source>%n views captured</source>
        <translation>
            <numerusform>%n vista capturada</numerusform>
            <numerusform>%n vistas capturadas</numerusform>
        </translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Hecho.</translation>
    </message>
    <message>
        <source>Press Start on the page Board.</source>
        <translation>Pulse Empezar en la página Tablero.</translation>
    </message>
    <message>
        <source>Waiting for images…</source>
        <translation>Esperando imágenes…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunAlerts</name>
    <message>
        <source>No camera has moved.</source>
        <translation>No se ha movido ninguna cámara.</translation>
    </message>
    <message>
        <source>The pose of %1 cannot be recomputed now.</source>
        <translation>La pose de %1 no se puede recalcular ahora.</translation>
    </message>
    <message>
        <source>Recompute pose of %1</source>
        <translation>Recalcular pose de %1</translation>
    </message>
    <message>
        <source>The pose of %1 was recomputed. Undo restores the previous pose.</source>
        <translation>La pose de %1 se recalculó. Deshacer restaura la pose anterior.</translation>
    </message>
    <message>
        <source>Disagreement with the other cameras: %1 before, %2 now.</source>
        <translation>Desacuerdo con las demás cámaras: antes %1, ahora %2.</translation>
    </message>
    <message>
        <source>Done: %1. You can undo this.</source>
        <translation>Hecho: %1. Puede deshacerlo.</translation>
    </message>
    <message>
        <source>No longer applies: %1</source>
        <translation>Ya no se aplica: %1</translation>
    </message>
    <message numerus="yes">
        <source>◆ %n notice(s)</source>
        <translation>
            <numerusform>◆ %n aviso</numerusform>
            <numerusform>◆ %n avisos</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the hidden notices</source>
        <translation>Mostrar los avisos ocultos</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunDetails</name>
    <message>
        <source>median %1, 99 % at most %2, longest %3</source>
        <translation>mediana %1, el 99 % como mucho %2, máximo %3</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>sin fijar</translation>
    </message>
    <message>
        <source>%1 (met by %2 % of the iterations of this run)</source>
        <translation>%1 (lo cumplió el %2 % de las iteraciones de esta ejecución)</translation>
    </message>
    <message>
        <source>Median time per iteration</source>
        <translation>Tiempo mediano por iteración</translation>
    </message>
    <message>
        <source>Time from camera image to estimate</source>
        <translation>Tiempo de la imagen de cámara a la estimación</translation>
    </message>
    <message>
        <source>Time budget per iteration</source>
        <translation>Límite de tiempo por iteración</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>Tamaño efectivo de la muestra</translation>
    </message>
    <message>
        <source>Iterations since the start</source>
        <translation>Iteraciones desde el inicio</translation>
    </message>
    <message>
        <source>Frames skipped</source>
        <translation>Fotogramas omitidos</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Semilla aleatoria</translation>
    </message>
    <message>
        <source>%1 of %2 particles</source>
        <translation>%1 de %2 partículas</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 de %2 MB</translation>
    </message>
    <message>
        <source>median %1, 99th percentile %2</source>
        <translation>mediana %1, percentil 99: %2</translation>
    </message>
    <message>
        <source>Median: capture %1 · decode %2 · wait %3 · compute %4 · draw %5</source>
        <translation>Mediana: captura %1 · decodificación %2 · espera %3 · cálculo %4 · dibujo %5</translation>
    </message>
    <message>
        <source>If a camera does not report capture times, the time is counted from the arrival of its image</source>
        <translation>Si una cámara no indica los tiempos de captura, el tiempo se cuenta desde la llegada de su imagen</translation>
    </message>
    <message>
        <source>Time from light to estimate</source>
        <translation>Tiempo desde la luz hasta la estimación</translation>
    </message>
    <message>
        <source>Memory for earlier frames</source>
        <translation>Memoria para fotogramas anteriores</translation>
    </message>
    <message>
        <source>Memory for going back to earlier frames: images, particles and saved states of the method. When it is full, only the estimates of older frames are kept.</source>
        <translation>Memoria para volver a fotogramas anteriores: imágenes, partículas y estados guardados del método. Cuando se llena, de los fotogramas antiguos solo se conservan las estimaciones.</translation>
    </message>
    <message>
        <source>99th percentile: capture %1 · decode %2 · wait %3 · compute %4 · draw %5</source>
        <translation>Percentil 99: captura %1 · decodificación %2 · espera %3 · cálculo %4 · dibujo %5</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SessionController</name>
    <message>
        <source>Restart the run? The results so far will be lost.</source>
        <translation>¿Reiniciar la ejecución? Se perderán los resultados obtenidos hasta ahora.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Use image size of the cameras</source>
        <translation>Tomar el tamaño de imagen de las cámaras</translation>
    </message>
    <message>
        <source>The recording has ended. Track it again from the beginning? The results so far will be lost.</source>
        <translation>La grabación ha terminado. ¿Volver a seguirla desde el principio? Los resultados obtenidos hasta ahora se perderán.</translation>
    </message>
    <message>
        <source>Track from the beginning</source>
        <translation>Seguir desde el principio</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Buscar acciones</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Descripción</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>Acciones y sus atajos</translation>
    </message>
    <message>
        <source>Click here and press the new keys of the chosen action</source>
        <translation>Haga clic aquí y pulse las nuevas teclas de la acción elegida</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Atajo nuevo</translation>
    </message>
    <message>
        <source>No shortcut</source>
        <translation>Sin atajo</translation>
    </message>
    <message>
        <source>Remove the shortcut of the selected action</source>
        <translation>Quitar el atajo de la acción seleccionada</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>Reset all shortcuts to their defaults</source>
        <translation>Restablecer todos los atajos a sus valores predeterminados</translation>
    </message>
    <message>
        <source>Choose an action, click the field below and press the new keys.</source>
        <translation>Elija una acción, haga clic en el campo de abajo y pulse las nuevas teclas.</translation>
    </message>
    <message>
        <source>“%1” no longer has a shortcut.</source>
        <translation>«%1» ya no tiene atajo.</translation>
    </message>
    <message>
        <source>All shortcuts were reset to their defaults.</source>
        <translation>Todos los atajos se restablecieron a sus valores predeterminados.</translation>
    </message>
    <message>
        <source>“%1” now has the shortcut %2.</source>
        <translation>«%1» tiene ahora el atajo %2.</translation>
    </message>
    <message>
        <source>“%1” now has the shortcut %2, which was removed from “%3”.</source>
        <translation>«%1» tiene ahora el atajo %2, que se quitó de «%3».</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; changed shortcuts are already saved</source>
        <translation>Cerrar; los atajos cambiados ya están guardados</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SourcePane</name>
    <message>
        <source>Connected to this computer</source>
        <translation>Conectadas a este ordenador</translation>
    </message>
    <message>
        <source>No camera is connected. Plug one in: it appears here by itself.</source>
        <translation>No hay ninguna cámara conectada. Conecte una: aparecerá aquí sola.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Assign to selected camera</source>
        <translation>Asignar a la cámara seleccionada</translation>
    </message>
    <message>
        <source>Network cameras, pipelines and test patterns</source>
        <translation>Cámaras de red, pipelines y cartas de ajuste</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Grabaciones</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>Añadir vídeos…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>Añadir carpeta de imágenes…</translation>
    </message>
    <message>
        <source>A simulated scene has its own cameras. They cannot be changed.</source>
        <translation>Una escena simulada tiene sus propias cámaras. No se pueden cambiar.</translation>
    </message>
    <message>
        <source>This project has live cameras. Recordings need a project of their own.</source>
        <translation>Este proyecto tiene cámaras en vivo. Las grabaciones necesitan un proyecto propio.</translation>
    </message>
    <message>
        <source>This project has recordings. Live cameras need a project of their own.</source>
        <translation>Este proyecto tiene grabaciones. Las cámaras en vivo necesitan un proyecto propio.</translation>
    </message>
    <message>
        <source>used by %1</source>
        <translation>usado por %1</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>The project uses this device already</source>
        <translation>El proyecto ya usa este dispositivo</translation>
    </message>
    <message>
        <source>Add the device as a new camera of the project</source>
        <translation>Añadir el dispositivo como nueva cámara del proyecto</translation>
    </message>
    <message>
        <source>Exchange the devices of this camera and of the selected camera</source>
        <translation>Intercambiar los dispositivos de esta cámara y de la seleccionada</translation>
    </message>
    <message>
        <source>Make this device the image source of the selected camera. The camera keeps its name and its calibration</source>
        <translation>Usar este dispositivo como fuente de imágenes de la cámara seleccionada. La cámara conserva su nombre y su calibración</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>Archivos de vídeo, uno por cámara</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>Una carpeta de imágenes, una por fotograma</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>Elija un vídeo por cámara</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>Vídeos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Elija una carpeta de imágenes</translation>
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
        <source>Playback speed of the recording. Live cameras are always tracked in real time.</source>
        <translation>Velocidad de reproducción de la grabación. Las cámaras en vivo se siguen siempre en tiempo real.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
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
        <translation>Probar la demo</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Proyectos recientes</translation>
    </message>
    <message>
        <source>You can also drop a project or videos onto this window.</source>
        <translation>También puede soltar un proyecto o vídeos sobre esta ventana.</translation>
    </message>
    <message>
        <source>Watch the filter converge</source>
        <translation>Vea cómo converge el filtro</translation>
    </message>
    <message>
        <source>A cloud of guesses slides along a line of sight and snaps onto the ball.</source>
        <translation>Una nube de suposiciones se desliza por una línea de visión y se cierra sobre la pelota.</translation>
    </message>
    <message>
        <source>Hidden for a second</source>
        <translation>Oculta durante un segundo</translation>
    </message>
    <message>
        <source>People in an office</source>
        <translation>Personas en una oficina</translation>
    </message>
    <message>
        <source>Four cameras find everyone in 3D and give each person a number.</source>
        <translation>Cuatro cámaras encuentran a cada persona en 3D y le dan un número.</translation>
    </message>
    <message>
        <source>One camera, target in a box</source>
        <translation>Una cámara, objetivo en un recuadro</translation>
    </message>
    <message>
        <source>Needs no calibration: the target is marked with a rectangle and tracked by its colors.</source>
        <translation>No necesita calibración: el objetivo se marca con un recuadro y se sigue por sus colores.</translation>
    </message>
    <message>
        <source>Calibrate by hand</source>
        <translation>Calibrar a mano</translation>
    </message>
    <message>
        <source>Drag a grid over the images until it matches the floor.</source>
        <translation>Arrastre una cuadrícula sobre las imágenes hasta que coincida con el suelo.</translation>
    </message>
    <message>
        <source>Follow colored objects in 3D with ordinary cameras.</source>
        <translation>Siga objetos de color en 3D con cámaras corrientes.</translation>
    </message>
    <message>
        <source>Two simulated cameras see a pink ball; a particle filter finds it and follows it through space. Pause, go back, change anything: you cannot break it.</source>
        <translation>Dos cámaras simuladas ven una pelota rosa; un filtro de partículas la encuentra y la sigue por el espacio. Pause, mire atrás, cámbielo todo: nada se puede estropear.</translation>
    </message>
    <message>
        <source>Your own data</source>
        <translation>Sus propios datos</translation>
    </message>
    <message>
        <source>Open videos…</source>
        <translation>Abrir vídeos…</translation>
    </message>
    <message>
        <source>One recording per camera</source>
        <translation>Una grabación por cámara</translation>
    </message>
    <message>
        <source>Use cameras…</source>
        <translation>Usar cámaras…</translation>
    </message>
    <message>
        <source>Connected cameras or network streams</source>
        <translation>Cámaras conectadas o flujos de red</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>Abrir un proyecto…</translation>
    </message>
    <message>
        <source>A project saved earlier</source>
        <translation>Un proyecto guardado antes</translation>
    </message>
    <message>
        <source>A box passes in front of the ball. One camera is enough to keep tracking the ball.</source>
        <translation>Una caja pasa ante la pelota. Basta una cámara para seguir la pelota.</translation>
    </message>
    <message>
        <source>Calibrate cameras…</source>
        <translation>Calibrar cámaras…</translation>
    </message>
    <message>
        <source>From videos of a board or a ball, step by step</source>
        <translation>Con vídeos de un tablero o una bola, paso a paso</translation>
    </message>
    <message>
        <source>Identical balls</source>
        <translation>Pelotas idénticas</translation>
    </message>
    <message>
        <source>Other balls have the same color, but only one ball moves.</source>
        <translation>Otras pelotas tienen el mismo color, pero solo una se mueve.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StatusBarPanel</name>
    <message>
        <source>playing</source>
        <translation>en marcha</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pausa</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>terminado</translation>
    </message>
    <message>
        <source>Estimated position of the target in the room</source>
        <translation>Posición estimada del objetivo en la sala</translation>
    </message>
    <message>
        <source>frame %1 / %2</source>
        <translation>fotograma %1 / %2</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>fotograma %1</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3</source>
        <translation>x %1  y %2  z %3</translation>
    </message>
    <message>
        <source>tracking again</source>
        <translation>siguiendo de nuevo</translation>
    </message>
    <message>
        <source>looking back</source>
        <translation>mirando atrás</translation>
    </message>
    <message>
        <source>State of the run: playing, paused, at the end, looking back at an earlier frame, or tracking again</source>
        <translation>Estado de la ejecución: en marcha, en pausa, al final, mirando un fotograma anterior o siguiendo de nuevo</translation>
    </message>
    <message>
        <source>the box shows the expected position</source>
        <translation>el recuadro muestra la posición esperada</translation>
    </message>
    <message>
        <source>click the object or drag a box around it</source>
        <translation>haga clic en el objeto o dibuje un recuadro a su alrededor</translation>
    </message>
    <message>
        <source>x %1  y %2  %3 × %4</source>
        <translation>x %1  y %2  %3 × %4</translation>
    </message>
    <message>
        <source>● people: %1</source>
        <translation>● personas: %1</translation>
    </message>
    <message>
        <source>○ people: %1, searching</source>
        <translation>○ personas: %1, buscando</translation>
    </message>
    <message>
        <source>other objects fit equally well: press X and drag the target to its position</source>
        <translation>otros objetos encajan igual: pulse X y arrastre el objetivo a su posición</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>Speed of the target in the room</source>
        <translation>Velocidad del objetivo en la sala</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>Timing, particles and memory used</source>
        <translation>Tiempos, partículas y memoria usada</translation>
    </message>
    <message>
        <source>Tracking: the cameras confirm the estimate. Ambiguous: another object fits about as well. Lost: not tracked for more than a second.</source>
        <translation>Seguido: las cámaras confirman la estimación. Ambiguo: otro objeto encaja casi igual de bien. Perdido: no seguido desde hace más de un segundo.</translation>
    </message>
    <message>
        <source>Uncertainty of the position: the standard deviations in x, y and z combined. The plots show each of the three</source>
        <translation>Incertidumbre de la posición: las desviaciones típicas en x, y y z combinadas. Los gráficos muestran cada una de las tres</translation>
    </message>
    <message>
        <source>Number of the frame shown, and number of all frames. Click to go to another frame</source>
        <translation>Número del fotograma mostrado y número total de fotogramas. Haga clic para ir a otro fotograma</translation>
    </message>
    <message>
        <source>Frames tracked per second, while playing</source>
        <translation>Fotogramas seguidos por segundo, durante la reproducción</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StepStrip</name>
    <message>
        <source>Step %1: %2</source>
        <translation>Paso %1: %2</translation>
    </message>
    <message>
        <source>Step %1: %2. %3</source>
        <translation>Paso %1: %2. %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeComparison</name>
    <message>
        <source>This take contains the results of the live run.</source>
        <translation>Esta toma contiene los resultados de la ejecución en vivo.</translation>
    </message>
    <message>
        <source>Compare results</source>
        <translation>Comparar resultados</translation>
    </message>
    <message>
        <source>Tracking the take again…</source>
        <translation>Siguiendo la toma de nuevo…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeController</name>
    <message>
        <source>The recording ended, because its cameras were closed.</source>
        <translation>La grabación terminó porque se cerraron sus cámaras.</translation>
    </message>
    <message>
        <source>Take %1 (%2) was saved in %3.</source>
        <translation>La toma %1 (%2) se ha guardado en %3.</translation>
    </message>
    <message>
        <source>Problem: %1</source>
        <translation>Problema: %1</translation>
    </message>
    <message>
        <source>Open take</source>
        <translation>Abrir la toma</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Mostrar la carpeta</translation>
    </message>
    <message>
        <source>Notes…</source>
        <translation>Notas…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeDialog</name>
    <message>
        <source>Take %1</source>
        <translation>Toma %1</translation>
    </message>
    <message>
        <source>Next take</source>
        <translation>Próxima toma</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>next free number</source>
        <translation>siguiente número libre</translation>
    </message>
    <message>
        <source>Number of the take and of its folder. The number increases by itself with each take.</source>
        <translation>Número de la toma y de su carpeta. El número aumenta por sí solo con cada toma.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Pre-roll</source>
        <translation>Pregrabación</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How many seconds before the start are recorded as well. For this, the last images of all cameras are kept in memory, up to 512 MB in total.</source>
        <translation>Tiempo anterior al inicio que también se graba. Para ello se guardan en memoria las últimas imágenes de todas las cámaras, hasta 512 MB en total.</translation>
    </message>
    <message>
        <source>Text that is saved with the take</source>
        <translation>Texto que se guarda con la toma</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetPanel</name>
    <message>
        <source>Targets</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Target name, as shown in views and files</source>
        <translation>Nombre del objetivo, en vistas y archivos</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Radius of the ball, 0 to 2,000 mm. If unknown, it is estimated.</source>
        <translation>Radio de la pelota, de 0 a 2000 mm. Si es desconocido, se estima.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automática</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>pelota</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>No target yet. In any camera image, click the object to track.</source>
        <translation>Aún no hay objetivo: haga clic en cualquier imagen en el objeto que quiere seguir.</translation>
    </message>
    <message>
        <source>Rename target</source>
        <translation>Renombrar el objetivo</translation>
    </message>
    <message>
        <source>Change radius</source>
        <translation>Cambiar el radio</translation>
    </message>
    <message>
        <source>Change shape</source>
        <translation>Cambiar la forma</translation>
    </message>
    <message>
        <source>Remove target</source>
        <translation>Quitar el objetivo</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view. It is tracked from there.</source>
        <translation>Haga clic en el objeto o dibuje un recuadro a su alrededor en cualquier cámara. Se sigue desde ahí.</translation>
    </message>
    <message>
        <source>No box in this frame.</source>
        <translation>Sin recuadro en este fotograma.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>radio %1</translation>
    </message>
    <message>
        <source>radius %1 (estimated)</source>
        <translation>radio %1 (estimado)</translation>
    </message>
    <message>
        <source>radius unknown</source>
        <translation>radio desconocido</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Add target</source>
        <translation>Añadir objetivo</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Recuadro</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Aprender</translation>
    </message>
    <message>
        <source>Ball: the outline of the target is a circle in every image. Any: the size of the target is learned, and its position is the center of the region that has its color. Automatic: the shape is determined from the images. Only method dewpoint uses this setting.</source>
        <translation>Pelota: el contorno del objetivo es un círculo en cada imagen. Cualquiera: se aprende el tamaño del objetivo, y su posición es el centro de la zona que tiene su color. Automática: la forma se determina con las imágenes. Solo el método dewpoint usa este ajuste.</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Radio (mm)</translation>
    </message>
    <message>
        <source>To learn the color of this target, press Learn and click the target in a camera image.</source>
        <translation>Para aprender el color de este objetivo, pulse Aprender y haga clic en el objetivo en una imagen de cámara.</translation>
    </message>
    <message>
        <source>Hide target</source>
        <translation>Ocultar el objetivo</translation>
    </message>
    <message>
        <source>Show target</source>
        <translation>Mostrar el objetivo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetRowDelegate</name>
    <message>
        <source>Hide this target in the images and in the bird&apos;s-eye view. It is still tracked.</source>
        <translation>Ocultar este objetivo en las imágenes y en la vista de pájaro. Se sigue igualmente.</translation>
    </message>
    <message>
        <source>Show this target in the images and in the bird&apos;s-eye view</source>
        <translation>Mostrar este objetivo en las imágenes y en la vista de pájaro</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ThreadCountDialog</name>
    <message>
        <source>Filter threads</source>
        <translation>Hilos del filtro</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Hilos</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>Number of threads that compute the filter. The results do not depend on it</source>
        <translation>Número de hilos que calculan el filtro. Los resultados no dependen de él</translation>
    </message>
    <message>
        <source>The new number is used from the next frame on.</source>
        <translation>El nuevo número se usa a partir del próximo fotograma.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>Use this number</source>
        <translation>Usar este número</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Close and keep the current number</source>
        <translation>Cerrar y conservar el número actual</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Timeline</name>
    <message>
        <source>Nothing tracked yet: press play (Space), then drag here to move through time.</source>
        <translation>Aún no hay seguimiento: reproduzca (Espacio) y después arrastre aquí por el tiempo.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>The change applies to new frames. Use “%1” to track again from the current frame.</source>
        <translation>El cambio se aplica a los fotogramas nuevos. Use «%1» para seguir de nuevo desde el fotograma actual.</translation>
    </message>
    <message>
        <source>After this frame, there are no new problems with targets or cameras.</source>
        <translation>Después de este fotograma no hay problemas nuevos con los objetivos ni las cámaras.</translation>
    </message>
    <message>
        <source>Before this frame, there are no other problems with targets or cameras.</source>
        <translation>Antes de este fotograma no hay otros problemas con los objetivos ni las cámaras.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TouchedInstantList</name>
    <message>
        <source>What the ball does at this time</source>
        <translation>Qué hace la pelota en este instante</translation>
    </message>
    <message>
        <source>Add current time</source>
        <translation>Añadir instante actual</translation>
    </message>
    <message>
        <source>Remove time</source>
        <translation>Quitar instante</translation>
    </message>
    <message>
        <source>Remove the selected time from the list</source>
        <translation>Quitar de la lista el instante elegido</translation>
    </message>
    <message>
        <source>Added times</source>
        <translation>Instantes añadidos</translation>
    </message>
    <message>
        <source>Double-click or press Enter to show the images of this time</source>
        <translation>Doble clic o Intro muestra las imágenes de este instante</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The upward direction is computed from three positions at which the ball touches the floor, or from a fall of the ball</source>
        <translation>La dirección hacia arriba se calcula con tres posiciones en que la pelota toca el suelo, o con una caída de la pelota</translation>
    </message>
    <message>
        <source>Add the time of the images shown to the list. In these images, the ball must do what you selected</source>
        <translation>Añadir a la lista el tiempo de las imágenes mostradas. En estas imágenes, la pelota debe hacer lo que usted ha elegido</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryModel</name>
    <message>
        <source>time, s</source>
        <translation>tiempo, s</translation>
    </message>
    <message>
        <source>Time of the frame, in seconds</source>
        <translation>Tiempo del fotograma, en segundos</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>fotograma</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>Fotograma, contado desde 1</translation>
    </message>
    <message>
        <source>target</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Nombre del objetivo</translation>
    </message>
    <message>
        <source>%1, m</source>
        <translation>%1, m</translation>
    </message>
    <message>
        <source>Position in the room, in meters</source>
        <translation>Posición en la sala, en metros</translation>
    </message>
    <message>
        <source>σ%1, mm</source>
        <translation>σ%1, mm</translation>
    </message>
    <message>
        <source>Standard deviation of the position, in millimeters</source>
        <translation>Desviación típica de la posición, en milímetros</translation>
    </message>
    <message>
        <source>speed, m/s</source>
        <translation>veloc., m/s</translation>
    </message>
    <message>
        <source>Speed in meters per second, computed from five frames</source>
        <translation>Velocidad en metros por segundo, calculada con cinco fotogramas</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>cámaras</translation>
    </message>
    <message>
        <source>existence</source>
        <translation>existencia</translation>
    </message>
    <message>
        <source>state</source>
        <translation>estado</translation>
    </message>
    <message>
        <source>◆ corrected</source>
        <translation>◆ corregido</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ ambiguo</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● seguido</translation>
    </message>
    <message>
        <source>○ not tracked</source>
        <translation>○ no seguido</translation>
    </message>
    <message>
        <source>Tracking: the cameras confirm the estimate. Ambiguous: another object fits about as well. Corrected: you set the position</source>
        <translation>Seguido: las cámaras confirman la estimación. Ambiguo: otro objeto encaja casi igual de bien. Corregido: usted fijó la posición</translation>
    </message>
    <message>
        <source>Number of cameras that see the target</source>
        <translation>Número de cámaras que ven el objetivo</translation>
    </message>
    <message>
        <source>Existence probability: how likely it is that the target is there and tracked, 0 to 1</source>
        <translation>Probabilidad de existencia: qué probable es que el objetivo esté ahí y se siga, de 0 a 1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryPanel</name>
    <message>
        <source>Trajectory</source>
        <translation>Trayectoria</translation>
    </message>
    <message>
        <source>Speed and height over time</source>
        <translation>Velocidad y altura en el tiempo</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message numerus="yes">
        <source>%n rows are on the clipboard as CSV.</source>
        <translation>
            <numerusform>%n fila está en el portapapeles como CSV.</numerusform>
            <numerusform>%n filas están en el portapapeles como CSV.</numerusform>
        </translation>
    </message>
    <message>
        <source>The trajectory appears here as soon as the target is tracked.</source>
        <translation>La trayectoria aparece aquí en cuanto se sigue el objetivo.</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n muestra</numerusform>
            <numerusform>%n muestras</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples, no gaps</source>
        <translation>
            <numerusform>%n muestra, sin huecos</numerusform>
            <numerusform>%n muestras, sin huecos</numerusform>
        </translation>
    </message>
    <message>
        <source>The boxes are on the clipboard as CSV.</source>
        <translation>Los recuadros están en el portapapeles como CSV.</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Quitar corrección</translation>
    </message>
    <message>
        <source>Speed and height appear during tracking.</source>
        <translation>La velocidad y la altura aparecen durante el seguimiento.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::UncertaintyMapForm</name>
    <message>
        <source>Show the map in the bird&apos;s-eye view</source>
        <translation>Mostrar el mapa en la vista de pájaro</translation>
    </message>
    <message>
        <source>Show the position error to expect for a target at each point. The map changes whenever a camera moves</source>
        <translation>Mostrar el error de posición que cabe esperar de un objetivo en cada punto. El mapa se actualiza con cada movimiento de una cámara</translation>
    </message>
    <message>
        <source>Colors show</source>
        <translation>Los colores muestran</translation>
    </message>
    <message>
        <source>the expected error</source>
        <translation>el error esperado</translation>
    </message>
    <message>
        <source>the number of cameras</source>
        <translation>el número de cámaras</translation>
    </message>
    <message>
        <source>Meaning of the colors</source>
        <translation>Significado de los colores</translation>
    </message>
    <message>
        <source>The expected error (standard deviation in the worst direction), or the number of cameras that see a point</source>
        <translation>El error esperado (desviación estándar en la peor dirección), o el número de cámaras que ven un punto</translation>
    </message>
    <message>
        <source>Acceptable error</source>
        <translation>Error aceptable</translation>
    </message>
    <message>
        <source>Errors up to this value are blue in the map. The summary and the search for a camera position also use this value</source>
        <translation>Los errores hasta este valor son azules en el mapa. También lo usan el resumen y la búsqueda de una posición de cámara</translation>
    </message>
    <message>
        <source>Detection error</source>
        <translation>Error de detección</translation>
    </message>
    <message>
        <source>Error of a target&apos;s position in an image, in pixels (one standard deviation)</source>
        <translation>Error de la posición de un objetivo en una imagen, en píxeles (una desviación estándar)</translation>
    </message>
    <message>
        <source>Layer at</source>
        <translation>Capa a</translation>
    </message>
    <message>
        <source>Show the map in a horizontal layer</source>
        <translation>Mostrar el mapa en una capa horizontal</translation>
    </message>
    <message>
        <source>Height of the layer above the floor</source>
        <translation>Altura de la capa sobre el suelo</translation>
    </message>
    <message>
        <source>Surfaces around good and fair regions</source>
        <translation>Superficies en torno a zonas buenas y aceptables</translation>
    </message>
    <message>
        <source>Volume: minimum x, y, z</source>
        <translation>Volumen: mínimo x, y, z</translation>
    </message>
    <message>
        <source>Volume: maximum x, y, z</source>
        <translation>Volumen: máximo x, y, z</translation>
    </message>
    <message>
        <source>Minimum %1 of the map&apos;s volume</source>
        <translation>Valor mínimo de %1 del volumen del mapa</translation>
    </message>
    <message>
        <source>Maximum %1 of the map&apos;s volume</source>
        <translation>Valor máximo de %1 del volumen del mapa</translation>
    </message>
    <message>
        <source>Set from reference grid</source>
        <translation>Tomar de la cuadrícula</translation>
    </message>
    <message>
        <source>Use the volume above the reference grid, up to the highest camera</source>
        <translation>Usar el volumen sobre la cuadrícula de referencia, hasta la cámara más alta</translation>
    </message>
    <message>
        <source>Height of the layer above the floor, in meters</source>
        <translation>Altura de la capa sobre el suelo, en metros</translation>
    </message>
    <message>
        <source>Show surfaces in the room. For the error: around the regions with at most 0.4, 1 and 2 times the acceptable error. For the number of cameras: around the regions that two, three and four cameras see</source>
        <translation>Mostrar superficies en la sala. Para el error: en torno a las regiones con como mucho 0,4, 1 y 2 veces el error aceptable. Para el número de cámaras: en torno a las regiones que ven dos, tres y cuatro cámaras</translation>
    </message>
    <message>
        <source>Smallest x, y and z of the volume, in meters</source>
        <translation>Valores mínimos de x, y y z del volumen, en metros</translation>
    </message>
    <message>
        <source>Largest x, y and z of the volume, in meters</source>
        <translation>Valores máximos de x, y y z del volumen, en metros</translation>
    </message>
    <message>
        <source>The error is at most %2 in %1 of the volume. Fewer than two cameras see %3 of the volume</source>
        <translation>El error es como mucho %2 en el %1 del volumen. Menos de dos cámaras ven el %3 del volumen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoDialog</name>
    <message>
        <source>Export video</source>
        <translation>Exportar vídeo</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Archivo que se escribe</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Examinar…</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>Elegir el archivo que se escribe</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop the export. No file is written</source>
        <translation>Detener la exportación; no queda ningún archivo</translation>
    </message>
    <message>
        <source>Write the video in the background</source>
        <translation>Escribir el vídeo en segundo plano</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; a running export continues</source>
        <translation>Cerrar; una exportación en curso continúa</translation>
    </message>
    <message>
        <source>Saved the video %1.</source>
        <translation>Se guardó el vídeo %1.</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>La exportación se canceló.</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 ya existe; no se escribió nada.</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>no view is checked</source>
        <translation>no hay ninguna vista marcada</translation>
    </message>
    <message>
        <source>Images: %1. Length: %2. Size: %3 × %4 pixels.</source>
        <translation>Imágenes: %1. Duración: %2. Tamaño: %3 × %4 píxeles.</translation>
    </message>
    <message>
        <source>This computer draws the bird&apos;s-eye view slowly. It is drawn in a smaller size and enlarged.</source>
        <translation>Este ordenador dibuja despacio la vista de pájaro. Se dibuja en menor tamaño y se amplía.</translation>
    </message>
    <message>
        <source>This computer has no encoder for videos.</source>
        <translation>Este ordenador no tiene ningún codificador de vídeo.</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>The export was stopped because the run has ended.</source>
        <translation>La exportación se detuvo porque la ejecución ha terminado.</translation>
    </message>
    <message>
        <source>The export was stopped because the run was restarted.</source>
        <translation>La exportación se detuvo porque la ejecución se reinició.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoForm</name>
    <message>
        <source>camera images</source>
        <translation>imágenes de las cámaras</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>pixels</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>MP4 (H.264)</source>
        <translation>MP4 (H.264)</translation>
    </message>
    <message>
        <source>WebM (VP8)</source>
        <translation>WebM (VP8)</translation>
    </message>
    <message>
        <source>AVI (Motion JPEG)</source>
        <translation>AVI (Motion JPEG)</translation>
    </message>
    <message>
        <source>Matroska (FFV1, lossless)</source>
        <translation>Matroska (FFV1, sin pérdidas)</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>The checked views are shown side by side</source>
        <translation>Las vistas marcadas se muestran una al lado de otra</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>Time in the recording at which the video begins, 0 to 1,000,000 s</source>
        <translation>Instante de la grabación en que empieza el vídeo, de 0 a 1.000.000 s</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Time in the recording at which the video ends, 0 to 1,000,000 s. The end is the last tracked frame; later frames have no results</source>
        <translation>Instante de la grabación en que termina el vídeo, de 0 a 1.000.000 s. El final es el último fotograma seguido; los posteriores no tienen resultados</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Speed of the video, up to 100: 1 is real time, 0.1 is ten times slower, and 8 is eight times faster. With 0, every frame is shown once</source>
        <translation>Velocidad del vídeo, hasta 100: 1 es tiempo real, 0,1 es diez veces más lento y 8 es ocho veces más rápido. Con 0, cada fotograma se muestra una vez</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Width and height of the video in pixels</source>
        <translation>Anchura y altura del vídeo en píxeles</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Frecuencia de imagen</translation>
    </message>
    <message>
        <source>Images of the video per second, 1 to 240</source>
        <translation>Imágenes del vídeo por segundo, de 1 a 240</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Formats that this computer can write</source>
        <translation>Formatos que este ordenador puede escribir</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>el principio</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>el final</translation>
    </message>
    <message>
        <source>show every frame once</source>
        <translation>mostrar cada fotograma una vez</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>como se grabó</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> por segundo</translation>
    </message>
    <message>
        <source>Titles of the views</source>
        <translation>Títulos de las vistas</translation>
    </message>
    <message>
        <source>Write the name of each view into its corner</source>
        <translation>Escribir el nombre de cada vista en su esquina</translation>
    </message>
    <message>
        <source>Frame and time</source>
        <translation>Fotograma y tiempo</translation>
    </message>
    <message>
        <source>Write the name of the recording, the frame number and the time into the video</source>
        <translation>Escribir el nombre de la grabación, el número del fotograma y el tiempo en el vídeo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Choose the image of the video that the preview shows</source>
        <translation>Elegir la imagen del vídeo que muestra la vista previa</translation>
    </message>
    <message>
        <source>Image %1 of %2: frame %3</source>
        <translation>Imagen %1 de %2: fotograma %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewButtons</name>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>View from above: X to the right, Y up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Vista desde arriba: X a la derecha, Y hacia arriba. Arrastrar para mover, rueda para acercar, doble clic para verlo todo.</translation>
    </message>
    <message>
        <source>View from the front: X to the right, Z up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Vista desde el frente: X a la derecha, Z hacia arriba. Arrastrar para mover, rueda para acercar, doble clic para verlo todo.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Fit everything in the view without changing the viewing direction (or double-click)</source>
        <translation>Ajustar todo a la vista sin cambiar la orientación (o doble clic)</translation>
    </message>
    <message>
        <source>Perspective view. Drag to orbit, Shift-drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Vista en perspectiva. Arrastrar para girar, Mayús y arrastrar para mover, rueda para acercar, doble clic para verlo todo.</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>View from the side: Y to the right, Z up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Vista desde el lado: Y a la derecha, Z hacia arriba. Arrastrar para mover, rueda para acercar, doble clic para verlo todo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewPictures</name>
    <message>
        <source>Save picture as PNG…</source>
        <translation>Guardar la imagen como PNG…</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar la imagen</translation>
    </message>
    <message>
        <source>Save a picture of %1</source>
        <translation>Guardar una imagen de %1</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Saved the picture %1.</source>
        <translation>Se guardó la imagen %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VolumeForm</name>
    <message>
        <source>Minimum X, Y, Z</source>
        <translation>Mínimo X, Y, Z</translation>
    </message>
    <message>
        <source>Maximum X, Y, Z</source>
        <translation>Máximo X, Y, Z</translation>
    </message>
    <message>
        <source>Minimum %1 of the volume of interest</source>
        <translation>Valor mínimo de %1 del volumen de interés</translation>
    </message>
    <message>
        <source>Maximum %1 of the volume of interest</source>
        <translation>Valor máximo de %1 del volumen de interés</translation>
    </message>
    <message>
        <source>Compute from cameras</source>
        <translation>De las cámaras</translation>
    </message>
    <message>
        <source>Search for targets in the box around the region that at least two cameras see</source>
        <translation>Buscar objetivos en la caja que rodea lo que ven al menos dos cámaras</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Search for targets anywhere</source>
        <translation>Buscar objetivos en cualquier lugar</translation>
    </message>
    <message>
        <source>Set volume of interest</source>
        <translation>Fijar el volumen de interés</translation>
    </message>
    <message>
        <source>Remove volume of interest</source>
        <translation>Quitar el volumen de interés</translation>
    </message>
    <message>
        <source>Targets are searched for only inside this box.</source>
        <translation>Los objetivos se buscan solo en esta caja.</translation>
    </message>
    <message>
        <source>None: targets are searched for everywhere. The numbers show the region that the cameras see; change one of them to search in a box.</source>
        <translation>Ninguno: los objetivos se buscan en cualquier lugar. Los números muestran la zona que ven las cámaras; cambie uno para buscar en una caja.</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. Change a number to search in a box.</source>
        <translation>Ninguno: los objetivos se buscan en cualquier lugar. Cambie un número para buscar en una caja.</translation>
    </message>
    <message>
        <source>Change volume of interest</source>
        <translation>Cambiar el volumen de interés</translation>
    </message>
    <message>
        <source>Smallest x, y and z of the volume of interest, in meters. Targets are searched for only inside this box</source>
        <translation>Valores mínimos de x, y y z del volumen de interés, en metros. Los objetivos se buscan solo dentro de esta caja</translation>
    </message>
    <message>
        <source>Largest x, y and z of the volume of interest, in meters. Targets are searched for only inside this box</source>
        <translation>Valores máximos de x, y y z del volumen de interés, en metros. Los objetivos se buscan solo dentro de esta caja</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrationPage</name>
    <message>
        <source>Align the cameras by hand until they are roughly right. Then wave the ball, or a wand with two balls, through the whole volume, and press Refine cameras.</source>
        <translation>Ajuste las cámaras a mano hasta que estén más o menos bien. Después agite la pelota, o una varita con dos pelotas, por todo el volumen y pulse «Refinar cámaras».</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Wand</source>
        <translation>Varita</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Refinar</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
    <message>
        <source>Align the cameras by hand until they are roughly right. Then refine them with a recording in which you wave a ball, or a wand with two balls, through the whole volume.</source>
        <translation>Ajuste las cámaras a mano hasta que estén más o menos bien. Después refínelas con una grabación en la que agita una pelota, o una varita con dos pelotas, por todo el volumen.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrator</name>
    <message>
        <source>Press “Start waving”, then wave for half a minute in the volume in which you want to track.</source>
        <translation>Pulse «Empezar a agitar» y agite durante medio minuto en el volumen en que quiere seguir.</translation>
    </message>
    <message>
        <source>Refine cameras with a wand</source>
        <translation>Refinar cámaras con una varita</translation>
    </message>
    <message>
        <source>Refine cameras with a ball</source>
        <translation>Refinar cámaras con una pelota</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandForm</name>
    <message>
        <source>the ball&apos;s diameter</source>
        <translation>el diámetro de la pelota</translation>
    </message>
    <message>
        <source>the ball&apos;s diameter, %1</source>
        <translation>el diámetro de la pelota, %1</translation>
    </message>
    <message>
        <source>the current camera positions</source>
        <translation>posiciones de cámara actuales</translation>
    </message>
    <message>
        <source>a known distance</source>
        <translation>una distancia conocida</translation>
    </message>
    <message>
        <source>Wand</source>
        <translation>Varita</translation>
    </message>
    <message>
        <source>one ball</source>
        <translation>una pelota</translation>
    </message>
    <message>
        <source>wand with two balls</source>
        <translation>varita con dos pelotas</translation>
    </message>
    <message>
        <source>Kind of wand</source>
        <translation>Tipo de varita</translation>
    </message>
    <message>
        <source>A wand with two balls also gives the scale. This scale is more accurate than one from a diameter or a distance</source>
        <translation>Una varita con dos pelotas da también la escala, con más precisión que un diámetro o una distancia</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Pelota</translation>
    </message>
    <message>
        <source>The target that you wave; it is detected by its color</source>
        <translation>El objetivo que agita; se detecta por su color</translation>
    </message>
    <message>
        <source>Second ball</source>
        <translation>Segunda pelota</translation>
    </message>
    <message>
        <source>The target at the other end of the wand</source>
        <translation>El objetivo del otro extremo de la varita</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Length of the wand</source>
        <translation>Longitud de la varita</translation>
    </message>
    <message>
        <source>Distance from the center of one ball to the center of the other</source>
        <translation>Distancia del centro de una pelota al de la otra</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Scale from</source>
        <translation>Escala de</translation>
    </message>
    <message>
        <source>Source of the scale</source>
        <translation>Origen de la escala</translation>
    </message>
    <message>
        <source>Images alone cannot show whether a room is large or small. A scale from the diameter of a ball is accurate to about one percent. A scale from a distance is as accurate as your measurement</source>
        <translation>Las imágenes solas no muestran si una sala es grande o pequeña. La escala obtenida del diámetro de una pelota es exacta hasta un uno por ciento. La obtenida de una distancia es tan exacta como su medición</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Known distance</source>
        <translation>Distancia conocida</translation>
    </message>
    <message>
        <source>Distance between the two positions at which the center of the ball was held</source>
        <translation>Distancia entre las dos posiciones en las que estuvo el centro de la pelota</translation>
    </message>
    <message>
        <source>Initial error</source>
        <translation>Error inicial</translation>
    </message>
    <message>
        <source>Expected error of the initial positions</source>
        <translation>Error esperado de las posiciones iniciales</translation>
    </message>
    <message>
        <source>Roughly how far each camera may be from its true position</source>
        <translation>Aproximadamente cuánto puede distar cada cámara de su posición real</translation>
    </message>
    <message>
        <source>Expected error of the initial rotations</source>
        <translation>Error esperado de los giros iniciales</translation>
    </message>
    <message>
        <source>Roughly how far each camera may be rotated from its true orientation</source>
        <translation>Aproximadamente cuánto puede estar girada cada cámara respecto a su orientación real</translation>
    </message>
    <message>
        <source>Find delays</source>
        <translation>Buscar retrasos</translation>
    </message>
    <message>
        <source>Find focal lengths</source>
        <translation>Buscar distancias focales</translation>
    </message>
    <message>
        <source>Also compute the focal length of each camera. Use this for lenses that were never calibrated, or whose zoom has changed</source>
        <translation>Calcular también la distancia focal de cada cámara, con lentes que nunca se calibraron o cuyo zoom ha cambiado</translation>
    </message>
    <message>
        <source>Find the distortion k1</source>
        <translation>Buscar la distorsión k1</translation>
    </message>
    <message>
        <source>Also compute the first distortion coefficient of each lens. For this, the ball must be seen up to the edges of the images</source>
        <translation>Calcular también el primer coeficiente de distorsión de cada lente. Para ello, la pelota debe verse hasta los bordes de las imágenes</translation>
    </message>
    <message>
        <source>Only the selected time span</source>
        <translation>Solo el tramo de tiempo elegido</translation>
    </message>
    <message>
        <source>Use only the part of the recording that is selected in the timeline</source>
        <translation>Usar solo la parte de la grabación seleccionada en la línea de tiempo</translation>
    </message>
    <message>
        <source>Also compute the delay of each camera. Use this if the cameras do not take their images at the same time</source>
        <translation>Calcular también el retraso de cada cámara, si las cámaras no toman sus imágenes al mismo tiempo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandOutcome</name>
    <message>
        <source>Refine cameras</source>
        <translation>Refinar cámaras</translation>
    </message>
    <message>
        <source>Detect the ball in all images and compute the cameras that fit best</source>
        <translation>Detectar la pelota en todas las imágenes y calcular las cámaras que mejor encajan</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop and keep the cameras unchanged</source>
        <translation>Detener y dejar las cámaras sin cambios</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Use calibration anyway</source>
        <translation>Usar la calibración de todos modos</translation>
    </message>
    <message>
        <source>Use this calibration although it looks wrong; you can undo this</source>
        <translation>Usar esta calibración aunque parece errónea; se puede deshacer</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Guardar informe…</translation>
    </message>
    <message>
        <source>Refined cameras</source>
        <translation>Cámaras refinadas</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>moved cm</source>
        <translation>movida cm</translation>
    </message>
    <message>
        <source>rotated °</source>
        <translation>girada °</translation>
    </message>
    <message>
        <source>delay ms</source>
        <translation>retraso ms</translation>
    </message>
    <message>
        <source>Reprojection error: root mean square distance between detected and projected balls</source>
        <translation>Error de reproyección: distancia cuadrática media entre las pelotas detectadas y las proyectadas</translation>
    </message>
    <message>
        <source>Distance between the old and the new position of the camera</source>
        <translation>Distancia entre la posición anterior y la nueva de la cámara</translation>
    </message>
    <message>
        <source>Angle between the old and the new orientation of the camera</source>
        <translation>Ángulo entre la orientación anterior y la nueva de la cámara</translation>
    </message>
    <message>
        <source>The cameras are unchanged.</source>
        <translation>Las cámaras no han cambiado.</translation>
    </message>
    <message>
        <source>The fall gives a gravity of %1 m/s² (9.81 is expected).</source>
        <translation>La caída da una gravedad de %1 m/s² (se espera 9,81).</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Páginas web (*.html)</translation>
    </message>
    <message>
        <source>Results for each camera; hover over a heading to see its meaning</source>
        <translation>Resultados de cada cámara; señale un encabezado para ver su significado</translation>
    </message>
    <message>
        <source>The cameras have changed since this refinement.</source>
        <translation>Las cámaras han cambiado desde este refinamiento.</translation>
    </message>
    <message>
        <source>Additional delay of this camera&apos;s images relative to the first camera</source>
        <translation>Retraso adicional de las imágenes de esta cámara respecto a la primera</translation>
    </message>
    <message>
        <source>Camera delays are saved in the project and used to synchronize images from now on.</source>
        <translation>Los retrasos de las cámaras se guardan en el proyecto y desde ahora sincronizan las imágenes.</translation>
    </message>
    <message>
        <source>Hold down this button to draw the grid with the calibration from before this refinement</source>
        <translation>Mantenga pulsado este botón para dibujar la cuadrícula con la calibración anterior a este refinamiento</translation>
    </message>
    <message>
        <source>Save a page with all numbers, the residuals as arrows, the coverage and a 3D drawing</source>
        <translation>Guardar una página con todos los números, los residuos como flechas, la cobertura y un dibujo en 3D</translation>
    </message>
    <message>
        <source>The result is less accurate than the initial camera positions: you entered that their error is at most %1. Wave through more of the volume.</source>
        <translation>El resultado es menos preciso que las posiciones iniciales de las cámaras: indicó que su error es como mucho %1. Agite por una parte mayor del volumen.</translation>
    </message>
    <message>
        <source>Calibrations from different parts of the recording differ from each other %1 times as much as image noise can explain. The stated accuracy takes this into account.</source>
        <translation>Las calibraciones con distintas partes de la grabación difieren %1 veces lo que explica el ruido de las imágenes. La precisión indicada lo tiene en cuenta.</translation>
    </message>
    <message>
        <source>%1 was far off: the refinement rotates this camera by %2 and moves it by %3, much more than the other cameras. Was it moved after its calibration?</source>
        <translation>%1 estaba muy desviada: el ajuste gira esta cámara %2 y la desplaza %3, mucho más que las demás cámaras. ¿Se movió después de calibrarla?</translation>
    </message>
    <message>
        <source>The previous calibration fits the images as well as the new one. Keep the previous one, or wave longer and through more of the volume.</source>
        <translation>La calibración anterior concuerda con las imágenes igual de bien que la nueva. Conserve la anterior, o agite durante más tiempo y por una parte mayor del volumen.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandWaving</name>
    <message>
        <source>Collect positions of the ball from all camera images. If you start again, the positions collected before are discarded</source>
        <translation>Reunir posiciones de la pelota de todas las imágenes. Si empieza de nuevo, se descartan las posiciones reunidas antes</translation>
    </message>
    <message>
        <source>■ Stop waving</source>
        <translation>■ Dejar de agitar</translation>
    </message>
    <message>
        <source>● Start waving</source>
        <translation>● Empezar a agitar</translation>
    </message>
    <message>
        <source>Stop waving</source>
        <translation>Dejar de agitar</translation>
    </message>
    <message>
        <source>Start waving</source>
        <translation>Empezar a agitar</translation>
    </message>
    <message>
        <source>No ball positions collected yet.</source>
        <translation>Aún no se ha reunido ninguna posición de la pelota.</translation>
    </message>
    <message>
        <source>Every camera has seen the ball often enough: stop waving, or press Refine cameras.</source>
        <translation>Cada cámara ha visto la pelota bastantes veces: deje de agitar o pulse «Refinar cámaras».</translation>
    </message>
    <message>
        <source>Frames skipped because they arrived too fast: %1.</source>
        <translation>Fotogramas omitidos por llegar demasiado rápido: %1.</translation>
    </message>
    <message>
        <source>The positions of the ball have been recorded for %1 so far.</source>
        <translation>Hasta ahora se han registrado las posiciones de la pelota durante %1.</translation>
    </message>
    <message>
        <source>Keep waving: each camera should see the ball at least 150 times, spread over at least half of its image.</source>
        <translation>Siga agitando: cada cámara debería ver la pelota al menos 150 veces, repartidas por al menos la mitad de su imagen.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WindowMenus</name>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Choose this camera</source>
        <translation>Elegir esta cámara</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Choose this target</source>
        <translation>Elegir este objetivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>&amp;Calibración</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;jecución</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Abrir reciente</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Show this view</source>
        <translation>Mostrar esta vista</translation>
    </message>
    <message>
        <source>Switch to this language</source>
        <translation>Cambiar a este idioma</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Según el sistema</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldMarkTool</name>
    <message>
        <source>Click point %1 in two images · Esc: stop</source>
        <translation>Haga clic en el punto %1 en dos imágenes · Esc: terminar</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter marks the point there</source>
        <translation>Imagen de %1: las flechas mueven una cruz, Intro marca allí el punto</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldMarks</name>
    <message>
        <source>Turn the world upright</source>
        <translation>Enderezar el mundo</translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation>Definir el suelo</translation>
    </message>
    <message>
        <source>Make a line level</source>
        <translation>Nivelar una línea</translation>
    </message>
    <message>
        <source>Set the origin</source>
        <translation>Definir el origen</translation>
    </message>
    <message>
        <source>Set the x axis</source>
        <translation>Definir el eje x</translation>
    </message>
    <message>
        <source>Set a distance</source>
        <translation>Definir una distancia</translation>
    </message>
    <message>
        <source>A, B and C lie on one line. Mark points that are spread over the floor.</source>
        <translation>A, B y C están en una línea. Marque puntos repartidos por el suelo.</translation>
    </message>
    <message>
        <source>The floor is set: A is the origin, and the x axis points to B. The world was rotated by %1.</source>
        <translation>El suelo está definido: A es el origen y el eje x apunta a B. El mundo se giró %1.</translation>
    </message>
    <message>
        <source>All lengths were multiplied by %1.</source>
        <translation>Todas las longitudes se multiplicaron por %1.</translation>
    </message>
    <message>
        <source>A is now the origin.</source>
        <translation>A es ahora el origen.</translation>
    </message>
    <message>
        <source>The world was rotated by %1.</source>
        <translation>El mundo se giró %1.</translation>
    </message>
    <message>
        <source>Rotate all cameras</source>
        <translation>Girar todas las cámaras</translation>
    </message>
    <message>
        <source>Move all cameras</source>
        <translation>Mover todas las cámaras</translation>
    </message>
    <message>
        <source>Check a distance</source>
        <translation>Comprobar una distancia</translation>
    </message>
    <message>
        <source>The line from A to B is far from horizontal.</source>
        <translation>La línea de A a B está lejos de ser horizontal.</translation>
    </message>
    <message>
        <source>A is directly above or below B, so the x axis cannot point from A to B.</source>
        <translation>A está justo encima o debajo de B, así que el eje x no puede apuntar de A a B.</translation>
    </message>
    <message>
        <source>From A to B, the calibration gives %1; you measured %2. The calibration is off by %3 %.</source>
        <translation>De A a B, la calibración da %1; usted midió %2. La calibración se desvía un %3 %.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldPage</name>
    <message>
        <source>Floor</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>⚠ The z axis does not seem to point up.</source>
        <translation>⚠ El eje z no parece apuntar hacia arriba.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
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
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
    <message>
        <source>Points of the room that you mark in the images, and their positions. ± is one standard deviation of a position, if clicks are accurate to 2 px.</source>
        <translation>Puntos de la sala que marca en las imágenes, y sus posiciones. ± es una desviación típica de la posición si los clics tienen una exactitud de 2 px.</translation>
    </message>
    <message>
        <source>Remove marks</source>
        <translation>Quitar marcas</translation>
    </message>
    <message>
        <source>Remove the marks of A, B and C from all images</source>
        <translation>Quitar las marcas de A, B y C de todas las imágenes</translation>
    </message>
    <message>
        <source>Floor, origin and scale</source>
        <translation>Suelo, origen y escala</translation>
    </message>
    <message>
        <source>Measured distance from A to B</source>
        <translation>Distancia medida de A a B</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>The distance that you measured in the room, in meters</source>
        <translation>La distancia que midió en la sala, en metros</translation>
    </message>
    <message>
        <source>Turn upright</source>
        <translation>Enderezar</translation>
    </message>
    <message>
        <source>Set floor from A, B and C</source>
        <translation>Definir suelo con A, B y C</translation>
    </message>
    <message>
        <source>The floor goes through A, B and C. A becomes the origin, and the x axis points to B.</source>
        <translation>El suelo pasa por A, B y C. A pasa a ser el origen y el eje x apunta a B.</translation>
    </message>
    <message>
        <source>Make line A–B level</source>
        <translation>Nivelar la línea A–B</translation>
    </message>
    <message>
        <source>Rotate the world by the smallest angle that makes this line horizontal</source>
        <translation>Girar el mundo con el menor ángulo que deja esta línea horizontal</translation>
    </message>
    <message>
        <source>Origin at A</source>
        <translation>Origen en A</translation>
    </message>
    <message>
        <source>Move the origin to A; the axes keep their directions</source>
        <translation>Mover el origen a A; los ejes conservan sus direcciones</translation>
    </message>
    <message>
        <source>x axis along A–B</source>
        <translation>Eje x a lo largo de A–B</translation>
    </message>
    <message>
        <source>Rotate the world about the vertical until the x axis points from A to B</source>
        <translation>Girar el mundo alrededor de la vertical hasta que el eje x apunte de A a B</translation>
    </message>
    <message>
        <source>Set scale</source>
        <translation>Definir escala</translation>
    </message>
    <message>
        <source>Multiply all lengths by one factor, so that the distance from A to B is the measured one</source>
        <translation>Multiplicar todas las longitudes por un factor, de modo que la distancia de A a B sea la medida</translation>
    </message>
    <message>
        <source>Move all cameras together</source>
        <translation>Mover todas las cámaras juntas</translation>
    </message>
    <message>
        <source>Shift of all cameras along %1</source>
        <translation>Desplazamiento de todas las cámaras a lo largo de %1</translation>
    </message>
    <message>
        <source>How far all cameras move along %1, in meters</source>
        <translation>Cuánto se desplazan todas las cámaras a lo largo de %1, en metros</translation>
    </message>
    <message>
        <source>Quarter turn about %1</source>
        <translation>Cuarto de vuelta alrededor de %1</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Rotation of all cameras about the vertical axis</source>
        <translation>Giro de todas las cámaras alrededor de la vertical</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Rotate and move all cameras together</source>
        <translation>Girar y mover todas las cámaras juntas</translation>
    </message>
    <message>
        <source>Quarter turn</source>
        <translation>Cuarto de vuelta</translation>
    </message>
    <message>
        <source>A: origin</source>
        <translation>A: origen</translation>
    </message>
    <message>
        <source>B: on the x axis</source>
        <translation>B: en el eje x</translation>
    </message>
    <message>
        <source>C: on the floor</source>
        <translation>C: en el suelo</translation>
    </message>
    <message>
        <source>Mark in images</source>
        <translation>Marcar en las imágenes</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Set the floor, the origin and the scale of the room. The cameras keep their positions relative to each other.</source>
        <translation>Defina el suelo, el origen y la escala de la sala. Las cámaras conservan sus posiciones relativas.</translation>
    </message>
    <message>
        <source>Compare the distance from A to B in the calibration with the distance that you measured. Nothing is changed.</source>
        <translation>Comparar la distancia de A a B en la calibración con la que usted midió. No se cambia nada.</translation>
    </message>
    <message>
        <source>Set floor from the board shown</source>
        <translation>Definir el suelo con el tablero mostrado</translation>
    </message>
    <message>
        <source>Use a board that lies flat on the floor in the images shown. Its first corner becomes the origin, and the x axis runs along its rows. Describe the board on the page Board.</source>
        <translation>Usar un tablero que está plano en el suelo en las imágenes mostradas. Su primera esquina será el origen y el eje x seguirá sus filas. Describa el tablero en la página Tablero.</translation>
    </message>
    <message>
        <source>Rotate the world by quarter turns until its upward direction points up in the images</source>
        <translation>Girar el mundo en cuartos de vuelta hasta que su dirección hacia arriba apunte hacia arriba en las imágenes</translation>
    </message>
    <message>
        <source>Rotate all cameras by 90° about the %1 axis, counterclockwise if the axis points toward you</source>
        <translation>Girar todas las cámaras 90° alrededor del eje %1, en sentido antihorario si el eje apunta hacia usted</translation>
    </message>
    <message>
        <source>Angle by which all cameras rotate about the vertical through the origin, counterclockwise as seen from above. The cameras are rotated first and then moved</source>
        <translation>Ángulo que giran todas las cámaras alrededor de la vertical por el origen, en sentido antihorario vistas desde arriba. Primero giran y después se mueven</translation>
    </message>
    <message>
        <source>Click the selected point in two or more images. Near a corner, the click moves exactly onto the corner; hold Alt to prevent this. Press Esc to finish.</source>
        <translation>Haga clic en el punto seleccionado en dos o más imágenes. Cerca de una esquina, el clic se mueve justo a la esquina; mantenga pulsada Alt para evitarlo. Pulse Esc para terminar.</translation>
    </message>
    <message>
        <source>marked</source>
        <translation>marcas</translation>
    </message>
</context>
</TS>
