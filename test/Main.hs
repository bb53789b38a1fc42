-- | All tests. Every module of this folder whose name ends in Spec is listed here ("StructureSpec" sees to it).
module Main
  ( main,
  )
where

import qualified Dioptre.Files.CounterSpec
import qualified Dioptre.Files.DescriptorSpec
import qualified Dioptre.Files.FaultSpec
import qualified Dioptre.Files.NumberSpec
import qualified Dioptre.Files.SearchSpec
import qualified Dioptre.Files.TemporarySpec
import qualified Dioptre.Files.WholeSpec
import qualified Dioptre.Geometry.BoundsSpec
import qualified Dioptre.Geometry.CapSpec
import qualified Dioptre.Geometry.ConeSpec
import qualified Dioptre.Geometry.CylinderSpec
import qualified Dioptre.Geometry.LensSpec
import qualified Dioptre.Geometry.PlacementSpec
import qualified Dioptre.Geometry.TorusSpec
import qualified Dioptre.Geometry.TubeSpec
import qualified Dioptre.Geometry.UvSpec
import qualified Dioptre.Math.QuarticSpec
import qualified Dioptre.Math.TransformSpec
import qualified Dioptre.Scene.CameraSpec
import qualified Dioptre.Scene.CheckSpec
import qualified Dioptre.Scene.ConfigurationSpec
import qualified Dioptre.Scene.FormSpec
import qualified Dioptre.Scene.LightsSpec
import qualified Dioptre.Scene.MaterialsSpec
import qualified Dioptre.Scene.RaytracerSpec
import qualified Dioptre.Scene.ShapesSpec
import qualified Dioptre.SceneSpec
import qualified Dioptre.Source.LanguageSpec
import qualified Dioptre.Source.MessageSpec
import qualified Dioptre.Source.ReportSpec
import qualified Dioptre.Source.TextSpec
import qualified Dioptre.Syntax.GrammarSpec
import qualified Dioptre.Syntax.KeywordSpec
import qualified Dioptre.Syntax.PrintSpec
import qualified Dioptre.Syntax.SpellingSpec
import qualified Dioptre.Syntax.ValueSpec
import GHC.IO.Encoding (mkTextEncoding, setFileSystemEncoding, setLocaleEncoding, utf8)
import qualified StructureSpec
import System.IO (hSetEncoding, stderr, stdout)
import Test.Hspec (Spec, describe, hspec)

main :: IO ()
main = do
  -- As the program does, first thing.
  mkTextEncoding "UTF-8//ROUNDTRIP" >>= setFileSystemEncoding
  setLocaleEncoding utf8
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  hspec specs

specs :: Spec
specs = do
  describe "The house" StructureSpec.spec
  describe "Dioptre.Files.Counter" Dioptre.Files.CounterSpec.spec
  describe "Dioptre.Files.Descriptor" Dioptre.Files.DescriptorSpec.spec
  describe "Dioptre.Files.Fault" Dioptre.Files.FaultSpec.spec
  describe "Dioptre.Files.Number" Dioptre.Files.NumberSpec.spec
  describe "Dioptre.Files.Search" Dioptre.Files.SearchSpec.spec
  describe "Dioptre.Files.Temporary" Dioptre.Files.TemporarySpec.spec
  describe "Dioptre.Files.Whole" Dioptre.Files.WholeSpec.spec
  describe "Dioptre.Geometry.Bounds" Dioptre.Geometry.BoundsSpec.spec
  describe "Dioptre.Geometry.Cap" Dioptre.Geometry.CapSpec.spec
  describe "Dioptre.Geometry.Cone" Dioptre.Geometry.ConeSpec.spec
  describe "Dioptre.Geometry.Cylinder" Dioptre.Geometry.CylinderSpec.spec
  describe "Dioptre.Geometry.Lens" Dioptre.Geometry.LensSpec.spec
  describe "Dioptre.Geometry.Placement" Dioptre.Geometry.PlacementSpec.spec
  describe "Dioptre.Geometry.Torus" Dioptre.Geometry.TorusSpec.spec
  describe "Dioptre.Geometry.Tube" Dioptre.Geometry.TubeSpec.spec
  describe "Dioptre.Geometry.Uv" Dioptre.Geometry.UvSpec.spec
  describe "Dioptre.Math.Quartic" Dioptre.Math.QuarticSpec.spec
  describe "Dioptre.Math.Transform" Dioptre.Math.TransformSpec.spec
  describe "Dioptre.Scene" Dioptre.SceneSpec.spec
  describe "Dioptre.Scene.Camera" Dioptre.Scene.CameraSpec.spec
  describe "Dioptre.Scene.Check" Dioptre.Scene.CheckSpec.spec
  describe "Dioptre.Scene.Configuration" Dioptre.Scene.ConfigurationSpec.spec
  describe "Dioptre.Scene.Form" Dioptre.Scene.FormSpec.spec
  describe "Dioptre.Scene.Lights" Dioptre.Scene.LightsSpec.spec
  describe "Dioptre.Scene.Materials" Dioptre.Scene.MaterialsSpec.spec
  describe "Dioptre.Scene.Raytracer" Dioptre.Scene.RaytracerSpec.spec
  describe "Dioptre.Scene.Shapes" Dioptre.Scene.ShapesSpec.spec
  describe "Dioptre.Source.Language" Dioptre.Source.LanguageSpec.spec
  describe "Dioptre.Source.Message" Dioptre.Source.MessageSpec.spec
  describe "Dioptre.Source.Report" Dioptre.Source.ReportSpec.spec
  describe "Dioptre.Source.Text" Dioptre.Source.TextSpec.spec
  describe "Dioptre.Syntax.Grammar" Dioptre.Syntax.GrammarSpec.spec
  describe "Dioptre.Syntax.Keyword" Dioptre.Syntax.KeywordSpec.spec
  describe "Dioptre.Syntax.Print" Dioptre.Syntax.PrintSpec.spec
  describe "Dioptre.Syntax.Spelling" Dioptre.Syntax.SpellingSpec.spec
  describe "Dioptre.Syntax.Value" Dioptre.Syntax.ValueSpec.spec
